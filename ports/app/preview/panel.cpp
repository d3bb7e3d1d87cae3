/* SPDX-License-Identifier: MIT */
/* The panel beside the picture, by Dear ImGui; the project's only C++ file.
 *
 * The panel's content is in C files (panel_top.c, panel_list.c, panel_value.c,
 * panel_performance.c), on top of the interface panel_ui.h.  This file implements the
 * interface with Dear ImGui, sets style and font, and passes events to Dear ImGui and
 * triangles back. */
#include <backends/imgui_impl_sdl.h>
#include <cfloat>
#include <cstring>
#include <imgui.h>
#include <new>
#include "panel_parts.h"
#include "panel_ui.h"

static_assert(sizeof(ImDrawVert) == sizeof(panel_vertex), "vertices are drawn in place");
static_assert(sizeof(ImDrawIdx) == sizeof(uint16_t), "and so are indices");

namespace {

constexpr float LETTERS = 13;           /* font size at scale 1, px */

panel *shown;                           /* one panel: Dear ImGui has one context */

ImU32 pack_ink(uint32_t rgb)
{
    return IM_COL32(rgb >> 16, rgb >> 8 & 255, rgb & 255, 255);
}

ImVec4 make_float_ink(uint32_t rgb)
{
    return ImGui::ColorConvertU32ToFloat4(pack_ink(rgb));
}

} // namespace

/* -- lengths and positions ------------------------------------------------------- */

float ui_px(float at_one)          { return SDL_floorf(at_one * shown->scale + 0.5f); }
float ui_wide(const char *text)    { return ImGui::CalcTextSize(text).x; }
float ui_letter(void)              { return ui_wide("0"); }
float ui_letter_high(void)         { return ImGui::GetFontSize(); }
float ui_high(void)                { return ImGui::GetFrameHeight(); }
float ui_gap(void)                 { return ImGui::GetStyle().ItemSpacing.x; }
float ui_room(void)                { return ImGui::GetContentRegionAvail().x; }
void  ui_go(float x, float y)      { ImGui::SetCursorScreenPos(ImVec2(x, y)); }
void  ui_push_id(int id)                { ImGui::PushID(id); }
void  ui_pop_id(void)                 { ImGui::PopID(); }
void  ui_begin(void)               { ImGui::BeginGroup(); }
void  ui_end(void)                 { ImGui::EndGroup(); }
void  ui_beside(float gap)         { ImGui::SameLine(0, gap); }
void  ui_take(float w, float h)    { ImGui::Dummy(ImVec2(w, h)); }

SDL_FPoint ui_position(void)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    return SDL_FPoint{ at.x, at.y };
}

bool ui_in_sight(float y, float margin)
{
    const float top = ImGui::GetWindowPos().y, high = ImGui::GetWindowHeight();
    return y + ui_high() + margin >= top && y <= top + high + margin;
}

void ui_indent(bool in)
{
    if (in)
        ImGui::Indent();
    else
        ImGui::Unindent();
}

/* -- drawing --------------------------------------------------------------------- */

void ui_box(float x, float y, float wide, float high, uint32_t colour)
{
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, y), ImVec2(x + wide, y + high),
                                              pack_ink(colour));
}

void ui_write(float x, float y, uint32_t colour, const char *text)
{
    const ImVec2 at(SDL_floorf(x), SDL_floorf(y));
    ImGui::GetWindowDrawList()->AddText(at, pack_ink(colour), text);
}

void ui_write_framed(float x, float y, uint32_t colour, const char *text)
{
    ui_write(x, y + ImGui::GetStyle().FramePadding.y, colour, text);
}

void ui_text(uint32_t colour, const char *text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, pack_ink(colour));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

void ui_text_wrapped(uint32_t colour, const char *text)
{
    ImGui::PushTextWrapPos(0);
    ui_text(colour, text);
    ImGui::PopTextWrapPos();
}

/* Places the tooltip beside the panel, on the picture's side, so that it does not cover
 * the panel. */
void ui_tip(const char *text)
{
    const SDL_Rect &w = shown->where;
    const float y = ImGui::GetItemRectMin().y, gap = ui_px(4);
    const float left = static_cast<float>(w.x), end = static_cast<float>(w.x + w.w);
    const float right = ImGui::GetIO().DisplaySize.x - end;
    const float room = SDL_max(left, right) - 2 * gap;
    if (room >= ui_px(150) && left >= right)
        ImGui::SetNextWindowPos(ImVec2(left - gap, y), ImGuiCond_Always, ImVec2(1, 0));
    else if (room >= ui_px(150))
        ImGui::SetNextWindowPos(ImVec2(end + gap, y));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(SDL_min(SDL_max(room - ui_px(20), ui_px(130)), ui_px(300)));
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/* -- state of the last widget, mouse, keyboard ----------------------------------- */

SDL_FRect ui_last(void)
{
    const ImVec2 a = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    return SDL_FRect{ a.x, a.y, size.x, size.y };
}

bool ui_hovered(void)              { return ImGui::IsItemHovered(); }
bool ui_focused(void)              { return ImGui::IsItemFocused(); }
bool ui_active(void)               { return ImGui::IsItemActive(); }
bool ui_left(void)                 { return ImGui::IsItemDeactivated(); }
bool ui_any_active(void)           { return ImGui::IsAnyItemActive(); }
bool ui_pressed(int button)        { return ImGui::IsMouseClicked(button); }
bool ui_ctrl(void)                 { return ImGui::GetIO().KeyCtrl; }
bool ui_moves(void)                { return ImGui::GetIO().NavVisible; }
double ui_time(void)               { return ImGui::GetTime(); }

bool ui_is_open(void)
{
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

bool ui_points(float x, float y, float wide, float high)
{
    return ImGui::IsWindowHovered()
        && ImGui::IsMouseHoveringRect(ImVec2(x, y), ImVec2(x + wide, y + high));
}

bool ui_enter(void)
{
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)
        || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
}

/* -- widgets --------------------------------------------------------------------- */

bool ui_button(const char *id, float wide, bool lit)
{
    ImGui::PushStyleColor(ImGuiCol_Button, pack_ink(lit ? UI_FULL : UI_FRAME));
    const bool pressed = ImGui::Button(id, ImVec2(wide, ui_high()));
    ImGui::PopStyleColor();
    return pressed;
}

bool ui_check(const char *id, bool *on)
{
    return ImGui::Checkbox(id, on);
}

bool ui_swatch(const char *id, uint32_t rgb, float wide)
{
    return ImGui::ColorButton(id, make_float_ink(rgb), ImGuiColorEditFlags_NoTooltip
                              | ImGuiColorEditFlags_NoDragDrop, ImVec2(wide, ui_high()));
}

bool ui_slide(const char *id, int *place, int steps, float wide)
{
    ImGui::SetNextItemWidth(wide);
    return ImGui::SliderInt(id, place, 0, steps, "", ImGuiSliderFlags_NoInput);
}

void ui_focus_next(void)
{
    ImGui::SetKeyboardFocusHere();
}

bool ui_field(const char *id, const char *hint, char *text, size_t bytes, float wide)
{
    ImGui::SetNextItemWidth(wide);
    return ImGui::InputTextWithHint(id, hint ? hint : "", text, bytes,
                                    ImGuiInputTextFlags_AutoSelectAll);
}

bool ui_head(const char *name, bool forced)
{
    if (forced)
        ImGui::SetNextItemOpen(true, ImGuiCond_Always);
    return ImGui::CollapsingHeader(name);
}

bool ui_list(const char *id, const char *text, float wide)
{
    ImGui::SetNextItemWidth(wide);
    return ImGui::BeginCombo(id, text, ImGuiComboFlags_HeightLarge
                             | (text ? 0 : ImGuiComboFlags_NoPreview
                                           | ImGuiComboFlags_PopupAlignLeft));
}

bool ui_choice(const char *text, bool chosen)
{
    const bool now = ImGui::Selectable(text, chosen);
    if (chosen && ImGui::IsWindowAppearing()) {
        ImGui::SetItemDefaultFocus();
        ImGui::SetScrollHereY();
    }
    return now;
}

void ui_list_end(void)
{
    ImGui::EndCombo();
}

void ui_pick_open(void)
{
    ImGui::OpenPopup("pick");
}

bool ui_pick(uint32_t *rgb)
{
    if (!ImGui::BeginPopup("pick"))
        return false;
    const ImVec4 was = make_float_ink(*rgb);
    float c[3] = { was.x, was.y, was.z };
    ImGui::SetNextItemWidth(ui_px(180));
    const bool moved = ImGui::ColorPicker3("##pick", c, ImGuiColorEditFlags_NoSidePreview
        | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions
        | ImGuiColorEditFlags_NoInputs);
    const ImU32 now = ImGui::ColorConvertFloat4ToU32(ImVec4(c[0], c[1], c[2], 1));
    *rgb = (now & 255) << 16 | (now >> 8 & 255) << 8 | (now >> 16 & 255);
    ImGui::EndPopup();
    return moved;
}

bool ui_tabs(void)                 { return ImGui::BeginTabBar("##tabs"); }
void ui_tab_end(void)              { ImGui::EndTabItem(); }
void ui_tabs_end(void)             { ImGui::EndTabBar(); }
void ui_scroll_end(void)           { ImGui::EndChild(); }

bool ui_tab(const char *name, bool now)
{
    return ImGui::BeginTabItem(name, nullptr, now ? ImGuiTabItemFlags_SetSelected : 0);
}

void ui_scroll(const char *id)
{
    ImGui::BeginChild(id, ImVec2(0, 0), false, ImGuiWindowFlags_NavFlattened);
}

/* -- style and font -------------------------------------------------------------- */

namespace {

void paint(ImGuiStyle &style)
{
    const struct { ImGuiCol of; uint32_t by; } colours[] = {
        { ImGuiCol_Text, UI_TEXT }, { ImGuiCol_TextDisabled, UI_DIM },
        { ImGuiCol_WindowBg, UI_BACK }, { ImGuiCol_PopupBg, UI_HEAD },
        { ImGuiCol_Border, UI_LINE }, { ImGuiCol_FrameBg, UI_FRAME },
        { ImGuiCol_FrameBgHovered, UI_OVER }, { ImGuiCol_FrameBgActive, UI_DOWN },
        { ImGuiCol_ScrollbarBg, UI_BACK }, { ImGuiCol_ScrollbarGrab, UI_FRAME },
        { ImGuiCol_ScrollbarGrabHovered, UI_OVER },
        { ImGuiCol_ScrollbarGrabActive, UI_DOWN }, { ImGuiCol_CheckMark, UI_SEA },
        { ImGuiCol_Button, UI_FRAME }, { ImGuiCol_ButtonHovered, UI_OVER },
        { ImGuiCol_ButtonActive, UI_DOWN }, { ImGuiCol_Header, UI_HEAD },
        { ImGuiCol_HeaderHovered, UI_FRAME }, { ImGuiCol_HeaderActive, UI_OVER },
        { ImGuiCol_Separator, UI_LINE }, { ImGuiCol_Tab, UI_HEAD },
        { ImGuiCol_TabHovered, UI_OVER }, { ImGuiCol_TabActive, UI_FULL },
        { ImGuiCol_TabUnfocused, UI_HEAD }, { ImGuiCol_TabUnfocusedActive, UI_FULL },
        { ImGuiCol_NavHighlight, UI_SEA }, { ImGuiCol_TextSelectedBg, UI_FULL },
    };
    for (const auto &c : colours)
        style.Colors[c.of] = make_float_ink(c.by);
    style.Colors[ImGuiCol_ChildBg] = style.Colors[ImGuiCol_SliderGrab]
        = style.Colors[ImGuiCol_SliderGrabActive] = ImVec4(0, 0, 0, 0);
}

/* Square corners and no anti-aliasing: plain rectangles draw fast and sharp. */
void set_style(void)
{
    ImGuiStyle &s = ImGui::GetStyle();
    s = ImGuiStyle();
    paint(s);
    s.AntiAliasedLines = s.AntiAliasedLinesUseTex = s.AntiAliasedFill = false;
    s.WindowRounding = s.ChildRounding = s.FrameRounding = s.PopupRounding = 0;
    s.ScrollbarRounding = s.GrabRounding = s.TabRounding = 0;
    s.WindowBorderSize = s.ChildBorderSize = s.FrameBorderSize = s.TabBorderSize = 0;
    s.WindowPadding = ImVec2(ui_px(8), ui_px(8));
    s.FramePadding = ImVec2(ui_px(5), ui_px(2));
    s.ItemSpacing = ImVec2(ui_px(4), ui_px(3));
    s.ItemInnerSpacing = ImVec2(ui_px(4), ui_px(4));
    s.ScrollbarSize = ui_px(10);
    s.GrabMinSize = ui_px(3);
    s.IndentSpacing = ui_px(8);
    s.WindowMinSize = ImVec2(1, 1);
}

/* Renders the font at its size in px, sharp at any scale. */
bool make_letters(panel *p)
{
    ImFontAtlas *const fonts = ImGui::GetIO().Fonts;
    ImFontConfig how;
    unsigned char *bytes;
    int wide, high;
    how.SizePixels = ui_px(LETTERS);
    how.OversampleH = how.OversampleV = 1;
    how.PixelSnapH = true;
    fonts->Clear();
    fonts->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    fonts->AddFontDefault(&how);
    fonts->GetTexDataAsAlpha8(&bytes, &wide, &high);
    if (!bytes
        || !panel_raster_set_atlas(&p->pen, bytes, wide, high, fonts->TexUvWhitePixel.x,
                                   fonts->TexUvWhitePixel.y))
        return false;
    fonts->SetTexID(p->pen.atlas);
    fonts->ClearTexData();
    return true;
}

/* -- input and output ------------------------------------------------------------ */

/* Sets the mouse position from window events.  The backend asks for the global mouse
 * state, which does not follow a pointer moved by a program. */
void point(const panel *p)
{
    int x, y;
    SDL_GetMouseState(&x, &y);
    if (SDL_GetRelativeMouseMode())
        ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
    else if (SDL_GetMouseFocus() == p->window)
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(x), static_cast<float>(y));
}

void hold(int mod)
{
    ImGuiIO &io = ImGui::GetIO();
    io.KeyCtrl = (mod & KMOD_CTRL) != 0;
    io.KeyShift = (mod & KMOD_SHIFT) != 0;
    io.KeyAlt = io.KeySuper = false;
}

void leave(panel *p)
{
    panel_keys_leave(&p->keys);
    p->typing = -1;
    ImGui::SetWindowFocus(nullptr);
}

/* Moves the keyboard focus as requested since the last frame, then passes the queued key
 * events. */
void feed(panel *p)
{
    SDL_Event event;
    if (p->keys.leave) {
        leave(p);
    } else if (p->keys.here && !ImGui::GetIO().NavActive) {
        ImGui::SetWindowFocus("##panel");
    }
    hold(SDL_GetModState());
    for (panel_keys_begin(&p->keys); panel_keys_next(&p->keys, &event);) {
        ImGui_ImplSDL2_ProcessEvent(&event);
        if (event.type != SDL_TEXTINPUT)
            hold(event.key.keysym.mod);
    }
}

void tell_keys(panel *p)
{
    p->keys.writes = ImGui::GetIO().WantTextInput;
    p->keys.over = ImGui::GetIO().WantCaptureMouse;
    p->keys.open = ui_is_open();
    p->keys.where = p->where;
}

void measure(panel *p, bool on)
{
    if (on != p->measures)
        p->host->measures(p->host->user, on);
    p->measures = on;
}

void show_tabs(panel *p)
{
    bool figures = false;
    if (!ui_tabs())
        return;
    const bool to_rows = p->to_rows;
    p->to_rows = false;
    if (ui_tab("parameters", to_rows)) {
        panel_list(p);
        ui_tab_end();
    }
    if (p->host->performance && ui_tab("figures", false)) {
        figures = true;
        panel_performance_show(p);
        ui_tab_end();
    }
    ui_tabs_end();
    measure(p, figures);
}

/* Shows the panel's window.  A line at the left edge marks the keyboard focus. */
void show(panel *p)
{
    const ImVec2 at(static_cast<float>(p->where.x), static_cast<float>(p->where.y));
    const ImVec2 size(static_cast<float>(p->where.w), static_cast<float>(p->where.h));
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("##panel", nullptr, ImGuiWindowFlags_NoDecoration
                 | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                 | ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (p->keys.here || panel_keys_types(&p->keys))
        ui_box(at.x, at.y, ui_px(2), size.y, UI_SEA);
    panel_rows_begin(p);
    panel_top(p);
    show_tabs(p);
    panel_rows_end(p);
    ImGui::End();
}

/* Appends the draw commands of one Dear ImGui list at index `n`.  Returns the new count. */
int add_calls(panel *p, const ImDrawList &list, int n)
{
    for (const ImDrawCmd &c : list.CmdBuffer) {
        const int x = static_cast<int>(c.ClipRect.x), y = static_cast<int>(c.ClipRect.y);
        const SDL_Rect clip = { x, y, static_cast<int>(c.ClipRect.z) - x,
                                static_cast<int>(c.ClipRect.w) - y };
        if (c.ElemCount == 0 || n == PANEL_CALLS || clip.w <= 0 || clip.h <= 0)
            continue;
        p->call[n++] = panel_draw_call{
            reinterpret_cast<const panel_vertex *>(list.VtxBuffer.Data + c.VtxOffset),
            list.VtxBuffer.Size - static_cast<int>(c.VtxOffset),
            list.IdxBuffer.Data + c.IdxOffset, static_cast<int>(c.ElemCount), clip };
    }
    return n;
}

bool is_own(const ImDrawList &list)
{
    return list._OwnerName && std::strncmp(list._OwnerName, "##panel", 7) == 0;
}

/* Draws the panel's own windows through the cache, then popups and tooltips, which reach
 * over the picture. */
void draw(panel *p, const ImDrawData &data)
{
    int n = 0;
    for (int i = 0; i < data.CmdListsCount; i++)
        if (is_own(*data.CmdLists[i]))
            n = add_calls(p, *data.CmdLists[i], n);
    panel_raster_draw_cached(&p->pen, p->call, n, &p->where);
    for (int i = 0; i < data.CmdListsCount; i++)
        if (!is_own(*data.CmdLists[i]))
            panel_raster_draw(&p->pen, p->call, add_calls(p, *data.CmdLists[i], 0));
}

/* Opens the requested scene after the frame, because the frame points into the host's
 * lists. */
void open_scene(panel *p)
{
    const uint32_t scene = p->to_open;
    p->to_open = UINT32_MAX;
    if (scene < p->host->scene_count)
        p->host->open(p->host->user, scene);
}

void hide(panel *p)
{
    leave(p);
    measure(p, false);
}

} // namespace

/* -- panel.h --------------------------------------------------------------------- */

bool panel_is_built(void)
{
    return true;
}

panel *panel_open(SDL_Window *window, SDL_Renderer *renderer, const panel_host *host)
{
    panel *const p = shown ? nullptr : new (std::nothrow) panel();
    if (!p)
        return nullptr;
    shown = p;
    p->host = host;
    p->window = window;
    p->scale = 1;
    p->typing = p->sliding = p->tip = -1;
    p->scene = p->to_open = UINT32_MAX;
    p->groups = panel_groups_collect(host, p->group);
    panel_raster_begin(&p->pen, renderer);
    p->imgui = ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    set_style();
    if (ImGui_ImplSDL2_InitForSDLRenderer(window) && make_letters(p))
        return p;
    panel_close(p);
    return nullptr;
}

bool panel_event(panel *p, const SDL_Event *event)
{
    if (!p)
        return false;
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
    case SDL_TEXTINPUT:
    case SDL_MOUSEMOTION:
        return !p->hidden && panel_keys_event(&p->keys, event);
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
    case SDL_MOUSEWHEEL: {
        const bool taken = !p->hidden && panel_keys_event(&p->keys, event);
        if (taken || event->type != SDL_MOUSEWHEEL)
            ImGui_ImplSDL2_ProcessEvent(event);
        return taken;
    }
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:       /* the textures are lost */
        make_letters(p);
        return false;
    default:
        ImGui_ImplSDL2_ProcessEvent(event);
        return false;
    }
}

/* Sets the cursor policy: over the panel Dear ImGui sets the cursor; elsewhere it must
 * not, because it would set its arrow at each frame. */
static void leave_pointer(void)
{
    ImGuiIO &io = ImGui::GetIO();
    const bool left = io.ConfigFlags & ImGuiConfigFlags_NoMouseCursorChange;
    if (io.WantCaptureMouse) {
        io.ConfigFlags &= ~ImGuiConfigFlags_NoMouseCursorChange;
    } else if (!left) {
        io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
        SDL_SetCursor(SDL_GetDefaultCursor());
    }
}

void panel_draw(panel *p, const SDL_Rect *where)
{
    if (!p)
        return;
    p->hidden = !where || where->w <= 0 || where->h <= 0;
    if (p->hidden) {
        hide(p);
        return;
    }
    p->where = *where;
    feed(p);
    leave_pointer();
    ImGui_ImplSDL2_NewFrame();
    point(p);
    ImGui::NewFrame();
    p->keys.writes = ImGui::GetIO().WantTextInput;
    show(p);
    tell_keys(p);
    ImGui::Render();
    draw(p, *ImGui::GetDrawData());
    open_scene(p);
}

void panel_scale(panel *p, float scale)
{
    if (!p || scale == p->scale || !(scale > 0))
        return;
    p->scale = scale;
    set_style();
    make_letters(p);
}

void panel_search(panel *p)
{
    if (!p)
        return;
    p->keys.searching = p->keys.here = p->to_rows = true;
    p->keys.leave = false;
    p->asked = 0;
}

bool panel_types(const panel *p)
{
    return p && !p->hidden && (p->keys.here || panel_keys_types(&p->keys));
}

void panel_close(panel *p)
{
    if (!p)
        return;
    measure(p, false);
    if (ImGui::GetIO().BackendPlatformUserData)
        ImGui_ImplSDL2_Shutdown();
    panel_raster_end(&p->pen);
    ImGui::DestroyContext(static_cast<ImGuiContext *>(p->imgui));
    shown = nullptr;
    delete p;
}
