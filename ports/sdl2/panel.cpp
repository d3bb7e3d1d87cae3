/* SPDX-License-Identifier: MIT */
/* The panel beside the picture, made of the table's rows by Dear ImGui.
 *
 * The project's one C++ file: what needs no Dear ImGui is C beside it, panel_rows.c (names,
 * search, numbers as text) and panel_ink.c (triangles to the window).  Nothing of a value is
 * kept here: each picture asks the host for what is in sight, and what a person does goes
 * back as text, as a scene file has it.
 *
 * The keyboard is the picture's until a person asks for the panel: by its search, by Tab or
 * by a click into a field.  Esc gives it back.  Keys wait in a queue of their own, for Dear
 * ImGui sees the state of keys and not their order: one that goes down and up between two
 * pictures would never have been. */
#include "panel.h"
#include "panel_ink.h"
#include "panel_rows.h"
#include "../host/actions.h"
#include <imgui.h>
#include <backends/imgui_impl_sdl.h>
#include <cfloat>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

static_assert(sizeof(ImDrawVert) == sizeof(ink_vertex), "vertices are drawn in place");
static_assert(sizeof(ImDrawIdx) == sizeof(uint16_t), "and so are indices");

namespace {

constexpr int   LETTERS = 13;           /* pixels of the default letters, at scale 1 */
constexpr int   KEYS = 64, CALLS = 256, PATIENCE = 8;
constexpr float TIP_S = 0.5f;

constexpr ImU32 BACK = IM_COL32(21, 25, 30, 255), FRAME = IM_COL32(36, 43, 51, 255),
                OVER = IM_COL32(47, 57, 67, 255), DOWN = IM_COL32(58, 74, 86, 255),
                HEAD = IM_COL32(29, 35, 42, 255), LINE = IM_COL32(52, 61, 70, 255),
                TEXT = IM_COL32(214, 221, 226, 255), DIM = IM_COL32(134, 147, 158, 255),
                SEA = IM_COL32(72, 176, 190, 255), EDITED = IM_COL32(232, 176, 96, 255),
                OVERDUE = IM_COL32(216, 104, 88, 255), FULL = IM_COL32(40, 76, 87, 255),
                HELD = IM_COL32(50, 102, 116, 255), EDGE = IM_COL32(56, 124, 138, 255);

} // namespace

struct panel {
    const panel_host *host;
    SDL_Window   *window;
    ImGuiContext *imgui;
    ink           pen;
    float         scale;
    panel_group   group[PANEL_GROUPS];
    uint32_t      groups, counted, scene;
    char          wanted[64];           /* what is searched for */
    int           typing;               /* row whose number is being typed, or -1 */
    int           sliding, place;       /* row that changes while it is held, or -1 */
    uint32_t      asked;                /* pictures since the keyboard was asked for */
    bool          typing_new, typing_seen, searching, shows_rows, measures, hidden, leave;
    bool          keys;                 /* the keyboard moves about in the panel */
    bool          on_number;            /* the keyboard's place in the panel */
    bool          taken;                /* the last key that went down */
    bool          mouse;                /* a button that went down here is held */
    SDL_Event     event[KEYS];          /* keys and letters that wait */
    uint32_t      events, waited;       /* and pictures since one could be told */
    int           tip, tip_new;         /* row that is pointed at, and since when */
    double        tip_since;
    SDL_Rect      where;
    ink_call      call[CALLS];
};

namespace {

/* -- events ------------------------------------------------------------------------------ */

bool is_plain(SDL_Keycode key)          /* makes a letter, which comes as text too */
{
    return key > SDLK_SPACE && key < 128 && key != SDLK_DELETE;
}

bool moves_about(SDL_Keycode key)
{
    return key == SDLK_TAB || key == SDLK_UP || key == SDLK_DOWN || key == SDLK_LEFT
        || key == SDLK_RIGHT || key == SDLK_SPACE || key == SDLK_RETURN
        || key == SDLK_KP_ENTER || key == SDLK_PAGEUP || key == SDLK_PAGEDOWN
        || key == SDLK_HOME || key == SDLK_END;
}

bool is_of_function(SDL_Scancode code)
{
    return (code >= SDL_SCANCODE_F1 && code <= SDL_SCANCODE_F12)
        || (code >= SDL_SCANCODE_F13 && code <= SDL_SCANCODE_F24);
}

/* Of a field that is typed in: its own Ctrl keys, but not those to save or quit. */
bool is_of_field(const SDL_Keysym &key)
{
    return !(key.mod & KMOD_CTRL) || std::strchr("acvxzy", key.sym < 128 ? key.sym : '?')
        || !is_plain(key.sym);
}

bool is_open()                          /* a list or a colour that dropped down */
{
    return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

void wait(panel *p, const SDL_Event &event)
{
    if (p->events < KEYS)
        p->event[p->events++] = event;
}

/* Whether a key that went down is the panel's. */
bool takes_key(panel *p, const SDL_Keysym &key)
{
    if (is_of_function(key.scancode) || key.sym == SDLK_LCTRL || key.sym == SDLK_RCTRL
        || key.sym == SDLK_LSHIFT || key.sym == SDLK_RSHIFT)
        return false;
    if (panel_types(p) || (p->keys && p->events > 0))
        return is_of_field(key);
    if (key.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI))
        return false;
    if (key.sym == SDLK_ESCAPE)
        return p->keys || is_open();
    if (key.sym == SDLK_TAB)
        p->keys = true;
    return (p->keys || is_open()) && moves_about(key.sym);
}

SDL_Event as_key(const SDL_Event &event, SDL_Scancode code)
{
    SDL_Event e = event;
    e.key.keysym.scancode = code;
    e.key.keysym.sym = SDL_GetKeyFromScancode(code);
    return e;
}

/* Tab goes on to the next thing as the arrow does, from a field too; Enter presses what
 * is no number and no field, as the space bar does. */
SDL_Event turned(const panel *p, const SDL_Event &event)
{
    const SDL_Keysym &key = event.key.keysym;
    if (key.sym == SDLK_TAB)
        return as_key(event, key.mod & KMOD_SHIFT ? SDL_SCANCODE_UP : SDL_SCANCODE_DOWN);
    if (!panel_types(p) && !p->on_number
        && (key.sym == SDLK_RETURN || key.sym == SDLK_KP_ENTER))
        return as_key(event, SDL_SCANCODE_SPACE);
    return event;
}

/* Whatever it went down as. */
void wait_for_up(panel *p, const SDL_Event &event)
{
    const SDL_Keycode key = event.key.keysym.sym;
    if (key == SDLK_TAB) {
        wait(p, as_key(event, SDL_SCANCODE_UP));
        wait(p, as_key(event, SDL_SCANCODE_DOWN));
        return;
    }
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER)
        wait(p, as_key(event, SDL_SCANCODE_SPACE));
    wait(p, event);
}

bool key_event(panel *p, const SDL_Event &event)
{
    const SDL_Keysym &key = event.key.keysym;
    const bool down = event.type == SDL_KEYDOWN;
    const bool taken = down && takes_key(p, key);
    const bool ctrl = (key.mod & KMOD_CTRL) != 0;
    if (down)
        p->taken = taken;
    if (key.sym == SDLK_ESCAPE && taken && !is_open())
        p->leave = true;
    else if (!down)
        wait_for_up(p, event);
    else if (taken && !event.key.repeat && (!is_plain(key.sym) || ctrl))
        wait(p, turned(p, event));
    return taken;
}

/* A letter is the panel's if its key was; "/" that asks to search and a blank
 * that presses a button are no letters. */
bool text_event(panel *p, const SDL_Event &event)
{
    const char *const text = event.text.text;
    if (!panel_types(p) && !p->taken)
        return false;
    if (std::strcmp(text, p->searching ? "/" : panel_types(p) ? "" : " ") != 0)
        wait(p, event);
    return true;
}

bool is_over(const panel *p, int x, int y)
{
    const SDL_Point at = { x, y };
    return SDL_PointInRect(&at, &p->where) || ImGui::GetIO().WantCaptureMouse;
}

bool mouse_event(panel *p, const SDL_Event &event)
{
    int x, y;
    const Uint32 held = SDL_GetMouseState(&x, &y);
    if (SDL_GetRelativeMouseMode())
        return false;
    if (event.type == SDL_MOUSEBUTTONDOWN) {
        const bool first = (held & ~SDL_BUTTON(event.button.button)) == 0;
        if (first)
            p->mouse = is_over(p, event.button.x, event.button.y);
        if (!p->mouse && p->keys)
            p->leave = true;
        ImGui_ImplSDL2_ProcessEvent(&event);
        return p->mouse;
    }
    if (event.type == SDL_MOUSEBUTTONUP) {
        ImGui_ImplSDL2_ProcessEvent(&event);
        return p->mouse;
    }
    if (held != 0)
        return p->mouse;
    const bool over = event.type == SDL_MOUSEMOTION
                    ? is_over(p, event.motion.x, event.motion.y) : is_over(p, x, y);
    if (event.type == SDL_MOUSEWHEEL && over)
        ImGui_ImplSDL2_ProcessEvent(&event);
    return over;
}

void hold(int mod)
{
    ImGuiIO &io = ImGui::GetIO();
    io.KeyCtrl = (mod & KMOD_CTRL) != 0;
    io.KeyShift = (mod & KMOD_SHIFT) != 0;
    io.KeyAlt = io.KeySuper = false;
}

/* As many of what waits as one picture can tell apart: keys that go up and letters, or
 * one key that goes down. */
void feed(panel *p)
{
    uint32_t n = 0;
    bool down = false, up = false;
    hold(SDL_GetModState());
    for (; n < p->events && !down; n++) {
        const SDL_Event &event = p->event[n];
        const bool text = event.type == SDL_TEXTINPUT;
        if (text && !ImGui::GetIO().WantTextInput)
            break;                      /* its field is not there yet */
        down = event.type == SDL_KEYDOWN;
        if (down && up)
            break;
        up = event.type == SDL_KEYUP;
        ImGui_ImplSDL2_ProcessEvent(&event);
        if (!text)
            hold(event.key.keysym.mod);
    }
    p->waited = n > 0 ? 0 : p->waited + 1;
    if (p->events > 0 && p->waited > PATIENCE)
        n = 1;                          /* and will not be */
    p->events -= n;
    std::memmove(p->event, p->event + n, p->events * sizeof *p->event);
}

/* -- looks ------------------------------------------------------------------------------- */

float px(const panel *p, float at_one)
{
    return SDL_floorf(at_one * p->scale + 0.5f);
}

void paint(ImGuiStyle &style)
{
    const struct { ImGuiCol of; ImU32 by; } colours[] = {
        { ImGuiCol_Text, TEXT }, { ImGuiCol_TextDisabled, DIM }, { ImGuiCol_WindowBg, BACK },
        { ImGuiCol_ChildBg, 0 }, { ImGuiCol_PopupBg, HEAD }, { ImGuiCol_Border, LINE },
        { ImGuiCol_FrameBg, FRAME }, { ImGuiCol_FrameBgHovered, OVER },
        { ImGuiCol_FrameBgActive, DOWN }, { ImGuiCol_ScrollbarBg, 0 },
        { ImGuiCol_ScrollbarGrab, FRAME }, { ImGuiCol_ScrollbarGrabHovered, OVER },
        { ImGuiCol_ScrollbarGrabActive, DOWN }, { ImGuiCol_CheckMark, SEA },
        { ImGuiCol_SliderGrab, 0 }, { ImGuiCol_SliderGrabActive, 0 },
        { ImGuiCol_Button, FRAME }, { ImGuiCol_ButtonHovered, OVER },
        { ImGuiCol_ButtonActive, DOWN }, { ImGuiCol_Header, HEAD },
        { ImGuiCol_HeaderHovered, FRAME }, { ImGuiCol_HeaderActive, OVER },
        { ImGuiCol_Separator, LINE }, { ImGuiCol_Tab, HEAD }, { ImGuiCol_TabHovered, OVER },
        { ImGuiCol_TabActive, FULL }, { ImGuiCol_TabUnfocused, HEAD },
        { ImGuiCol_TabUnfocusedActive, FULL }, { ImGuiCol_NavHighlight, SEA },
        { ImGuiCol_TextSelectedBg, FULL },
    };
    for (const auto &c : colours)
        style.Colors[c.of] = ImGui::ColorConvertU32ToFloat4(c.by);
}

/* Square and without soft edges: rectangles are quick, and crisp. */
void set_style(panel *p)
{
    ImGuiStyle &s = ImGui::GetStyle();
    s = ImGuiStyle();
    paint(s);
    s.AntiAliasedLines = s.AntiAliasedLinesUseTex = s.AntiAliasedFill = false;
    s.WindowRounding = s.ChildRounding = s.FrameRounding = s.PopupRounding = 0;
    s.ScrollbarRounding = s.GrabRounding = s.TabRounding = 0;
    s.WindowBorderSize = s.ChildBorderSize = s.FrameBorderSize = s.TabBorderSize = 0;
    s.WindowPadding = ImVec2(px(p, 8), px(p, 8));
    s.FramePadding = ImVec2(px(p, 5), px(p, 2));
    s.ItemSpacing = ImVec2(px(p, 4), px(p, 3));
    s.ItemInnerSpacing = ImVec2(px(p, 4), px(p, 4));
    s.ScrollbarSize = px(p, 10);
    s.GrabMinSize = px(p, 3);
    s.IndentSpacing = px(p, 8);
    s.WindowMinSize = ImVec2(1, 1);
}

bool make_letters(panel *p)
{
    ImFontAtlas *const fonts = ImGui::GetIO().Fonts;
    ImFontConfig how;
    unsigned char *bytes;
    int wide, high;
    how.SizePixels = px(p, LETTERS);
    how.OversampleH = how.OversampleV = 1;
    how.PixelSnapH = true;
    fonts->Clear();
    fonts->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    fonts->AddFontDefault(&how);
    fonts->GetTexDataAsAlpha8(&bytes, &wide, &high);
    if (!bytes || !ink_atlas(&p->pen, bytes, wide, high, fonts->TexUvWhitePixel.x,
                             fonts->TexUvWhitePixel.y))
        return false;
    fonts->SetTexID(p->pen.atlas);
    fonts->ClearTexData();
    return true;
}

float letter(void)                      /* all are as wide */
{
    return ImGui::CalcTextSize("0").x;
}

void say(ImU32 colour, const char *text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

void tip(const panel *p, const char *text);

/* A line in what is left of the width, cut with dots; pointed at, it shows the whole. */
void say_line(const panel *p, ImU32 colour, const char *text)
{
    char cut[PANEL_TEXT];
    const int fits = static_cast<int>(ImGui::GetContentRegionAvail().x / letter());
    const int all = static_cast<int>(std::strlen(text));
    std::snprintf(cut, sizeof cut, "%.*s%s", all > fits ? fits - 2 : all, text,
                  all > fits ? ".." : "");
    say(colour, cut);
    if (all > fits && ImGui::IsItemHovered())
        tip(p, text);
}

/* Beside the panel and not over it: on the side where the picture is. */
void place_tip(const panel *p, float y)
{
    const float left = static_cast<float>(p->where.x), gap = px(p, 4);
    const float right = ImGui::GetIO().DisplaySize.x - left - static_cast<float>(p->where.w);
    if (SDL_max(left, right) < px(p, 160))
        return;
    if (left >= right)
        ImGui::SetNextWindowPos(ImVec2(left - gap, y), ImGuiCond_Always, ImVec2(1, 0));
    else
        ImGui::SetNextWindowPos(ImVec2(left + static_cast<float>(p->where.w) + gap, y));
}

void tip(const panel *p, const char *text)
{
    place_tip(p, ImGui::GetItemRectMin().y);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(px(p, 300));
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void write_at(float x, float y, ImU32 colour, const char *text)
{
    ImGui::GetWindowDrawList()->AddText(ImVec2(SDL_floorf(x), SDL_floorf(y)), colour, text);
}

void box(float x, float y, float wide, float high, ImU32 colour)
{
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, y), ImVec2(x + wide, y + high),
                                              colour);
}

/* -- what a key does, does a button too ---------------------------------------------------- */

struct button { int action; const char *name, *name_on; };

constexpr button BUTTONS[] = {
    { ACT_PAUSE, "pause", "go on" }, { ACT_STEP, "step", "step" },
    { ACT_RESTART, "restart", "restart" }, { ACT_UNDO, "undo", "undo" },
    { ACT_REDO, "redo", "redo" }, { ACT_SAVE, "save", "save" },
    { ACT_FILM, "film", "end film" }, { ACT_TAPE, "tape", "end tape" },
    { ACT_SHOT, "picture", "picture" },
};

void act_tip(const panel *p, int action)
{
    const bool save = action == ACT_SAVE && p->host->saved_as && p->host->saved_as[0];
    char text[PANEL_TEXT * 2];
    std::snprintf(text, sizeof text, "%s%s%s", actions[action].help, save ? "\n" : "",
                  save ? p->host->saved_as : "");
    if (ImGui::IsItemHovered())
        tip(p, text);
}

/* The name at the left, the key dim at the right if there is room. */
void act_button(panel *p, int action, const char *name, float wide)
{
    const panel_host &h = *p->host;
    const bool on = h.is_on(h.user, action);
    const char *const key = h.keys(h.user, action);
    ImGui::PushID(action);
    if (on)
        ImGui::PushStyleColor(ImGuiCol_Button, FULL);
    const bool pressed = ImGui::Button("##act", ImVec2(wide, 0));
    if (on)
        ImGui::PopStyleColor();
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    const float gap = px(p, 5), y = a.y + ImGui::GetStyle().FramePadding.y;
    const float key_wide = ImGui::CalcTextSize(key).x;
    write_at(a.x + gap, y, TEXT, name);
    if (ImGui::CalcTextSize(name).x + key_wide + 3 * gap <= b.x - a.x)
        write_at(b.x - gap - key_wide, y, DIM, key);
    act_tip(p, action);
    ImGui::PopID();
    if (pressed)
        h.act(h.user, action);
}

void show_buttons(panel *p)
{
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const int columns = room >= 13 * 3 * letter() ? 3 : 2;
    const float wide = SDL_floorf((room - gap * static_cast<float>(columns - 1))
                                  / static_cast<float>(columns));
    int i = 0;
    for (const button &b : BUTTONS) {
        if (i++ % columns != 0)
            ImGui::SameLine();
        act_button(p, b.action, p->host->is_on(p->host->user, b.action) ? b.name_on : b.name,
                   wide);
    }
}

void show_scenes(panel *p)
{
    const panel_host &h = *p->host;
    const bool known = h.scene < h.scene_count;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##scene", known ? h.scenes[h.scene] : "", 0)) {
        for (uint32_t i = 0; i < h.scene_count; i++) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(h.scenes[i], i == h.scene))
                h.open(h.user, i);
            if (i == h.scene && ImGui::IsWindowAppearing())
                ImGui::SetScrollHereY();
            if (ImGui::IsItemHovered() && h.shows[i])
                tip(p, h.shows[i]);
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    say_line(p, DIM, known && h.shows[h.scene] ? h.shows[h.scene] : "");
}

/* -- rows -------------------------------------------------------------------------------- */

/* Dear ImGui answers in the picture after, and begins anew if it is asked again. */
void ask_keys(panel *p)
{
    if (p->asked++ % 4 == 0)
        ImGui::SetKeyboardFocusHere();
}

bool enter_pressed()
{
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)
        || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
}

void put(panel *p, uint32_t row, const char *text)
{
    p->host->set(p->host->user, row, text, false);
}

/* While something is held: one change, however many steps it has. */
void put_on(panel *p, uint32_t row, const char *text, const char *before)
{
    if (std::strcmp(text, before) == 0)
        return;
    p->host->set(p->host->user, row, text, true);
    p->sliding = static_cast<int>(row);
}

/* It was let go of. */
void end_sliding(panel *p)
{
    char text[PANEL_TEXT];
    if (p->sliding < 0 || ImGui::IsAnyItemActive())
        return;
    const uint32_t row = static_cast<uint32_t>(p->sliding);
    p->host->get(p->host->user, row, text);
    put(p, row, text);
    p->sliding = -1;
}

/* A field of text; what was typed is set when it is left, if it is another. */
void show_field(panel *p, uint32_t row, const char *text)
{
    char typed[PANEL_TEXT];
    std::snprintf(typed, sizeof typed, "%s", text);
    ImGui::InputText("##v", typed, sizeof typed, ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemDeactivated() && std::strcmp(typed, text) != 0)
        put(p, row, typed);
}

void type_number(panel *p, uint32_t row, const char *text)
{
    p->typing_seen = true;
    if (p->typing_new && p->asked == 0) {       /* once without: the slider lets go */
        p->asked = 4;
        ImGui::Dummy(ImVec2(ImGui::CalcItemWidth(), ImGui::GetFrameHeight()));
        return;
    }
    if (p->typing_new)
        ask_keys(p);
    show_field(p, row, text);
    if (ImGui::IsItemActive())
        p->typing_new = false;
    else if (!p->typing_new)
        p->typing = -1;
}

void begin_typing(panel *p, uint32_t row)
{
    p->typing = static_cast<int>(row);
    p->typing_new = p->typing_seen = true;
    p->asked = 0;
}

/* How far the slider is, and over it the value and its unit. */
void write_value(const panel *p, const panel_row &row, const char *text, float share)
{
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    const float y = a.y + ImGui::GetStyle().FramePadding.y, edge = px(p, 2);
    const float gap = px(p, 5), unit = ImGui::CalcTextSize(row.unit).x;
    const float wide = ImGui::CalcTextSize(text).x;
    const float at = SDL_floorf((b.x - a.x - edge) * share);
    box(a.x, a.y, at, b.y - a.y, ImGui::IsItemActive() ? HELD : FULL);
    box(a.x + at, a.y, edge, b.y - a.y, EDGE);
    box(a.x + at, b.y - 2 * edge, edge, 2 * edge, SEA);
    write_at(a.x + gap, y, TEXT, text);
    if (row.unit[0] && wide + unit + 3 * gap <= b.x - a.x)
        write_at(b.x - gap - unit, y, DIM, row.unit);
}

/* A slider of places.  While it is held its place is kept: steps of a key may be finer
 * than the numbers that they make. */
void slide(panel *p, uint32_t row, const char *text)
{
    char made[PANEL_TEXT];
    const panel_row &r = p->host->row[row];
    const double value = std::strtod(text, nullptr);
    const panel_span span = panel_span_of(&r, value);
    int place = p->sliding == static_cast<int>(row) ? p->place : panel_place(&span, value);
    if (ImGui::SliderInt("##v", &place, 0, span.steps, "", ImGuiSliderFlags_NoInput)) {
        panel_number(&span, place, made);
        put_on(p, row, made, text);
        p->place = place;
    }
    p->on_number |= ImGui::IsItemFocused();
    if (ImGui::IsItemFocused() && enter_pressed())
        begin_typing(p, row);
    write_value(p, r, text, static_cast<float>(place) / static_cast<float>(span.steps));
}

/* Pressed with Ctrl, with the right button or by Enter it is typed instead. */
void show_number(panel *p, uint32_t row, const char *text)
{
    const ImVec2 a = ImGui::GetCursorScreenPos();
    const ImVec2 b(a.x + ImGui::CalcItemWidth(), a.y + ImGui::GetFrameHeight());
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(a, b)
        && (ImGui::IsMouseClicked(1) || (ImGui::IsMouseClicked(0) && ImGui::GetIO().KeyCtrl)))
        begin_typing(p, row);
    if (p->typing == static_cast<int>(row)) {
        type_number(p, row, text);
        return;
    }
    slide(p, row, text);
}

void show_switch(panel *p, uint32_t row, const char *text)
{
    bool on = std::strcmp(text, "on") == 0;
    if (ImGui::Checkbox("##v", &on))
        put(p, row, on ? "on" : "off");
}

void show_colour(panel *p, uint32_t row, const char *text)
{
    const ImU32 rgb = panel_colour(text);
    float c[3] = { static_cast<float>(rgb >> 16) / 255.0f,
                   static_cast<float>(rgb >> 8 & 255) / 255.0f,
                   static_cast<float>(rgb & 255) / 255.0f };
    const float wide = ImGui::CalcItemWidth(), high = ImGui::GetFrameHeight();
    if (ImGui::ColorButton("##swatch", ImVec4(c[0], c[1], c[2], 1),
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           ImVec2(2 * high, high)))
        ImGui::OpenPopup("pick");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(wide - 2 * high - ImGui::GetStyle().ItemSpacing.x);
    show_field(p, row, text);
    if (!ImGui::BeginPopup("pick"))
        return;
    char made[PANEL_TEXT];
    ImGui::SetNextItemWidth(px(p, 180));
    const bool moved = ImGui::ColorPicker3("##pick", c,
        ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoLabel
        | ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoInputs);
    std::snprintf(made, sizeof made, "#%02x%02x%02x", static_cast<int>(c[0] * 255 + 0.5f),
                  static_cast<int>(c[1] * 255 + 0.5f), static_cast<int>(c[2] * 255 + 0.5f));
    if (moved)
        put_on(p, row, made, text);
    ImGui::EndPopup();
}

void show_choice(panel *p, uint32_t row, const char *text)
{
    char word[PANEL_TEXT];
    if (!ImGui::BeginCombo("##v", text, ImGuiComboFlags_HeightLarge))
        return;
    for (uint32_t i = 0; panel_word(p->host->row[row].unit, i, word); i++)
        if (ImGui::Selectable(word, std::strcmp(word, text) == 0))
            put(p, row, word);
    ImGui::EndCombo();
}

/* The name can be typed, or taken from those that there are. */
void show_picture(panel *p, uint32_t row, const char *text)
{
    const panel_host &h = *p->host;
    const float arrow = ImGui::GetFrameHeight();
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - arrow - px(p, 1));
    show_field(p, row, text);
    ImGui::SameLine(0, px(p, 1));
    if (!ImGui::BeginCombo("##of", "", ImGuiComboFlags_NoPreview | ImGuiComboFlags_HeightLarge
                                       | ImGuiComboFlags_PopupAlignLeft))
        return;
    if (ImGui::Selectable("none", text[0] == '\0'))
        put(p, row, "");
    for (uint32_t i = 0; i < h.picture_count; i++)
        if (ImGui::Selectable(h.pictures[i], std::strcmp(h.pictures[i], text) == 0))
            put(p, row, h.pictures[i]);
    ImGui::EndCombo();
}

void show_value(panel *p, uint32_t row, const char *text)
{
    switch (p->host->row[row].kind) {
    case PANEL_NUMBER:
    case PANEL_COUNT:   show_number(p, row, text);  break;
    case PANEL_SWITCH:  show_switch(p, row, text);  break;
    case PANEL_COLOUR:  show_colour(p, row, text);  break;
    case PANEL_CHOICE:  show_choice(p, row, text);  break;
    case PANEL_PICTURE: show_picture(p, row, text); break;
    case PANEL_MESH:
    case PANEL_WORDS:   show_field(p, row, text);   break;
    }
}

/* At the end of the row, where a value is not the file's or not the default. */
void show_reset(panel *p, uint32_t row, bool filed)
{
    const float side = ImGui::GetFrameHeight();
    if (ImGui::Button("##reset", ImVec2(side, side)))
        p->host->reset(p->host->user, row);
    if (ImGui::IsItemHovered())
        tip(p, filed ? "to the default" : "as the scene's file has it");
    const ImVec2 a = ImGui::GetItemRectMin();
    write_at(a.x + (side - letter()) / 2, a.y + ImGui::GetStyle().FramePadding.y,
             filed ? DIM : EDITED, "<");
}

/* Help of a row that the mouse or the keyboard stays on for a while. */
void show_tip(panel *p, uint32_t row, const ImVec2 &at)
{
    char text[512];
    const ImVec2 end(at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetFrameHeight());
    const bool mouse = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end);
    const bool focus = p->keys && ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    if ((!mouse && !focus) || ImGui::IsAnyItemActive() || is_open())
        return;
    p->tip_new = static_cast<int>(row);
    if (p->tip != p->tip_new || ImGui::GetTime() - p->tip_since < TIP_S)
        return;
    panel_tip(&p->host->row[row], text, sizeof text);
    tip(p, text);
}

/* Rows that are not in sight take their room and no time; the next ones above and below
 * are there for the arrow keys to go to. */
bool out_of_sight(const ImVec2 &at, float high)
{
    const ImVec2 top = ImGui::GetWindowPos();
    return at.y + 4 * high < top.y || at.y > top.y + ImGui::GetWindowHeight() + 3 * high;
}

void show_row(panel *p, uint32_t row)
{
    char label[PANEL_NAME], text[PANEL_TEXT];
    const panel_host &h = *p->host;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x, high = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float names = SDL_floorf(SDL_min(room * 0.4f, 19 * letter()));
    if (out_of_sight(at, high)) {
        ImGui::Dummy(ImVec2(room, high));
        return;
    }
    const bool normal = h.is_normal(h.user, row), filed = h.is_filed(h.user, row);
    h.get(h.user, row, text);
    panel_label(&h.row[row], static_cast<uint32_t>(names / letter()), label);
    write_at(at.x, at.y + ImGui::GetStyle().FramePadding.y,
             !filed ? EDITED : normal ? DIM : TEXT, label);
    ImGui::PushID(static_cast<int>(row));
    ImGui::BeginGroup();
    ImGui::SetCursorScreenPos(ImVec2(at.x + names + gap, at.y));
    ImGui::SetNextItemWidth(room - names - 2 * gap - high);
    ImGui::PushItemWidth(room - names - 2 * gap - high);
    show_value(p, row, text);
    ImGui::PopItemWidth();
    show_tip(p, row, at);
    if (!normal || !filed) {
        ImGui::SameLine();
        ImGui::SetCursorScreenPos(ImVec2(at.x + room - high, at.y));
        show_reset(p, row, filed);
    }
    ImGui::EndGroup();
    ImGui::PopID();
}

/* -- groups ------------------------------------------------------------------------------ */

bool show_head(const char *name, const char *more, bool forced)
{
    if (forced)
        ImGui::SetNextItemOpen(true, ImGuiCond_Always);
    const bool open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_SpanFullWidth);
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    write_at(b.x - ImGui::CalcTextSize(more).x - 2 * ImGui::GetStyle().FramePadding.x,
             a.y + ImGui::GetStyle().FramePadding.y, DIM, more);
    return open;
}

uint32_t found_in(const panel *p, const panel_group &g)
{
    uint32_t n = 0;
    for (uint32_t i = g.first; i < g.first + g.count; i++)
        n += panel_found(&p->host->row[i], p->wanted);
    return n;
}

void show_group(panel *p, const panel_group &g)
{
    char more[24] = "";
    const bool wants = p->wanted[0] != '\0';
    if (wants && found_in(p, g) == 0)
        return;
    if (g.changed > 0)
        std::snprintf(more, sizeof more, "%u", static_cast<unsigned>(g.changed));
    ImGui::PushID(wants ? "found" : "all");
    if (show_head(g.name, more, wants)) {
        ImGui::Indent();
        for (uint32_t i = g.first; i < g.first + g.count; i++)
            if (panel_found(&p->host->row[i], p->wanted))
                show_row(p, i);
        ImGui::Unindent();
    }
    ImGui::PopID();
}

void show_groups(panel *p)
{
    uint32_t idle = 0;
    const bool wants = p->wanted[0] != '\0';
    for (uint32_t i = 0; i < p->groups; i++) {
        idle += p->group[i].idle;
        if (wants || !p->group[i].idle)
            show_group(p, p->group[i]);
    }
    char more[24];
    std::snprintf(more, sizeof more, "%u", static_cast<unsigned>(idle));
    if (wants || idle == 0 || !show_head("not in this scene", more, false))
        return;
    ImGui::Indent();
    for (uint32_t i = 0; i < p->groups; i++)
        if (p->group[i].idle)
            show_group(p, p->group[i]);
    ImGui::Unindent();
}

/* Another scene has other idle groups; else one group a picture is counted. */
void count_groups(panel *p)
{
    if (p->scene != p->host->scene)
        for (uint32_t i = 0; i < p->groups; i++)
            panel_group_count(p->host, &p->group[i], true);
    p->scene = p->host->scene;
    if (p->groups > 0)
        panel_group_count(p->host, &p->group[p->counted++ % p->groups], false);
}

void show_search(panel *p)
{
    const float clear = p->wanted[0] ? ImGui::GetFrameHeight() + px(p, 1) : 0;
    if (p->searching)
        ask_keys(p);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - clear);
    ImGui::InputTextWithHint("##search", "search names and help", p->wanted,
                             sizeof p->wanted, ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive() && ImGui::GetIO().WantTextInput)
        p->searching = false;
    if (clear > 0) {
        ImGui::SameLine(0, px(p, 1));
        if (ImGui::Button("x##clear", ImVec2(ImGui::GetFrameHeight(), 0)))
            p->wanted[0] = '\0';
    }
}

/* -- figures ----------------------------------------------------------------------------- */

void show_graph(const panel *p, const panel_figures &f)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float wide = ImGui::GetContentRegionAvail().x, high = px(p, 60);
    const uint32_t n = SDL_min(f.pictures, static_cast<uint32_t>(PANEL_HISTORY));
    float top = f.limit_ms * 1.5f;
    for (uint32_t i = PANEL_HISTORY - n; i < PANEL_HISTORY; i++)
        top = SDL_max(top, f.history[i]);
    box(at.x, at.y, wide, high, FRAME);
    const uint32_t bars = SDL_min(n, static_cast<uint32_t>(wide));
    const float step = SDL_max(1.0f, SDL_floorf(wide / PANEL_HISTORY));
    for (uint32_t i = 0; i < bars && top > 0; i++) {
        const float ms = f.history[PANEL_HISTORY - 1 - i];
        const float x = at.x + wide - static_cast<float>(i + 1) * step;
        const float tall = SDL_ceilf(SDL_max(ms, 0.0f) / top * high);
        if (x >= at.x)
            box(x, at.y + high - tall, step, tall, ms > f.limit_ms ? OVERDUE : SEA);
    }
    if (top > 0) {
        char text[32];
        const float y = SDL_floorf(at.y + high - f.limit_ms / top * high);
        box(at.x, y, wide, 1, EDITED);
        std::snprintf(text, sizeof text, "%.1f ms", static_cast<double>(f.limit_ms));
        write_at(at.x + px(p, 3), y - ImGui::GetFontSize(), DIM, text);
    }
    ImGui::Dummy(ImVec2(wide, high));
}

/* Name, a bar behind it as long as its share, and its time at the right. */
void show_times(const panel *p, const panel_time *time, uint32_t count)
{
    const float high = ImGui::GetFontSize() + px(p, 2);
    for (uint32_t i = 0; i < count; i++) {
        char text[32], name[PANEL_NAME];
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float wide = ImGui::GetContentRegionAvail().x;
        const float share = SDL_clamp(time[i].share, 0.0f, 1.0f);
        std::snprintf(text, sizeof text, "%.0f us %3.0f%%", static_cast<double>(time[i].mean),
                      static_cast<double>(share) * 100);
        const float end = ImGui::CalcTextSize(text).x;
        const int fits = SDL_max(0, static_cast<int>((wide - end) / letter()) - 1);
        std::snprintf(name, sizeof name, "%.*s", fits, time[i].name);
        box(at.x, at.y, SDL_ceilf(share * wide), high, FULL);
        write_at(at.x + px(p, 3), at.y, TEXT, name);
        write_at(at.x + wide - end, at.y, DIM, text);
        ImGui::Dummy(ImVec2(wide, high));
    }
}

/* Lines of columns parted by tabs; the last column takes what is left. */
void show_lines(const panel *p, const char *lines)
{
    for (int row = 0; lines && *lines; row++) {
        const size_t bytes = std::strcspn(lines, "\n");
        char line[256], *at = line;
        std::snprintf(line, sizeof line, "%.*s", static_cast<int>(bytes), lines);
        ImGui::PushID(row);
        for (int column = 0; at; column++) {
            char *const tab = std::strchr(at, '\t');
            if (tab)
                *tab = '\0';
            if (column > 0)
                ImGui::SameLine(SDL_max(ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x
                                        + letter(), static_cast<float>(11 * column)
                                        * letter()));
            say_line(p, column == 0 ? DIM : TEXT, at);
            at = tab ? tab + 1 : nullptr;
        }
        ImGui::PopID();
        lines += bytes + (lines[bytes] == '\n');
    }
}

void show_compare(panel *p, const panel_compare &c)
{
    char text[64];
    const float room = ImGui::GetContentRegionAvail().x;
    const float half = SDL_floorf((room - ImGui::GetStyle().ItemSpacing.x) / 2);
    act_button(p, ACT_COMPARE, c.off, half);
    ImGui::SameLine();
    act_button(p, ACT_AGAINST, c.against, half);
    if (c.psnr > 99)
        std::snprintf(text, sizeof text, "the same bits");
    else if (c.psnr >= 0)
        std::snprintf(text, sizeof text, "PSNR %.1f dB", c.psnr);
    else
        std::snprintf(text, sizeof text, "PSNR --");
    say(TEXT, text);
    if (c.note && c.note[0])
        say_line(p, DIM, c.note);
}

void section(const char *name)
{
    ImGui::Spacing();
    say(SEA, name);
}

void show_figures(panel *p)
{
    const panel_figures *const f = p->host->figures;
    char text[96];
    std::snprintf(text, sizeof text, "%.1f ms   %.0f/s   answers in %.0f ms",
                  static_cast<double>(f->median_ms), static_cast<double>(f->shown_per_s),
                  static_cast<double>(f->latency_ms));
    say_line(p, TEXT, text);
    show_graph(p, *f);
    if (f->state && f->state[0]) {
        ImGui::PushStyleColor(ImGuiCol_Text, DIM);
        ImGui::TextWrapped("%s", f->state);
        ImGui::PopStyleColor();
    }
    section("compared with another way to draw");
    if (p->host->compare)
        show_compare(p, *p->host->compare);
    section("a picture's time");
    show_times(p, f->parts, SDL_min(f->part_count, static_cast<uint32_t>(PANEL_TIMES)));
    section("stages of its pixels");
    show_times(p, f->stages, SDL_min(f->stage_count, static_cast<uint32_t>(PANEL_TIMES)));
    if (f->stage_count == 0)
        say(DIM, "not measured");
    section("plan of this moment");
    show_lines(p, f->plan);
    section("memory");
    show_lines(p, f->ram);
}

void measure(panel *p, bool on)
{
    if (on != p->measures)
        p->host->measures(p->host->user, on);
    p->measures = on;
}

/* -- the whole --------------------------------------------------------------------------- */

void show_tabs(panel *p)
{
    bool figures = false;
    if (!ImGui::BeginTabBar("##tabs", 0))
        return;
    const ImGuiTabItemFlags first = p->shows_rows ? ImGuiTabItemFlags_SetSelected : 0;
    p->shows_rows = false;
    if (ImGui::BeginTabItem("parameters", nullptr, first)) {
        show_search(p);
        ImGui::BeginChild("##rows", ImVec2(0, 0), false, ImGuiWindowFlags_NavFlattened);
        show_groups(p);
        ImGui::EndChild();
        ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("figures")) {
        figures = p->host->figures != nullptr;
        ImGui::BeginChild("##figures", ImVec2(0, 0), false, ImGuiWindowFlags_NavFlattened);
        if (figures)
            show_figures(p);
        ImGui::EndChild();
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
    measure(p, figures);
}

void show(panel *p)
{
    const SDL_Rect &w = p->where;
    ImGui::SetNextWindowPos(ImVec2(static_cast<float>(w.x), static_cast<float>(w.y)));
    ImGui::SetNextWindowSize(ImVec2(static_cast<float>(w.w), static_cast<float>(w.h)));
    ImGui::Begin("##panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
        | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (p->keys || panel_types(p))      /* the keyboard is here */
        box(static_cast<float>(w.x), static_cast<float>(w.y), px(p, 2),
            static_cast<float>(w.h), SEA);
    show_scenes(p);
    show_buttons(p);
    say_line(p, EDITED, p->host->message ? p->host->message : "");
    show_tabs(p);
    ImGui::End();
}

/* Where the mouse points by the window's events: the backend asks the whole screen, which
 * does not hear of a pointer that a program moved. */
void point(const panel *p)
{
    int x, y;
    SDL_GetMouseState(&x, &y);
    if (SDL_GetRelativeMouseMode())
        ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
    else if (SDL_GetMouseFocus() == p->window)
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(x), static_cast<float>(y));
}

/* Who has the keyboard, before a picture: what was asked for since the last one. */
void give_keys(panel *p)
{
    if (p->leave || p->hidden) {
        p->leave = p->keys = p->searching = false;
        ImGui::SetWindowFocus(nullptr);
    } else if (p->keys && !ImGui::GetIO().NavActive) {
        ImGui::SetWindowFocus("##panel");
    }
}

/* What a list of Dear ImGui's wants drawn, behind the calls that there are. */
int add_calls(panel *p, const ImDrawList &list, int n)
{
    for (const ImDrawCmd &c : list.CmdBuffer) {
        const int x = static_cast<int>(c.ClipRect.x), y = static_cast<int>(c.ClipRect.y);
        const SDL_Rect clip = { x, y, static_cast<int>(c.ClipRect.z) - x,
                                static_cast<int>(c.ClipRect.w) - y };
        if (c.ElemCount == 0 || n == CALLS || clip.w <= 0 || clip.h <= 0)
            continue;
        p->call[n++] = ink_call{
            reinterpret_cast<const ink_vertex *>(list.VtxBuffer.Data + c.VtxOffset),
            list.VtxBuffer.Size - static_cast<int>(c.VtxOffset),
            list.IdxBuffer.Data + c.IdxOffset, static_cast<int>(c.ElemCount), clip };
    }
    return n;
}

/* The panel's own window and those in it; then lists that dropped down and tips, which
 * reach over the picture. */
void draw(panel *p, const ImDrawData &data)
{
    int n = 0;
    const auto is_own = [](const ImDrawList &list) {
        return list._OwnerName && std::strncmp(list._OwnerName, "##panel", 7) == 0;
    };
    for (int i = 0; i < data.CmdListsCount; i++)
        if (is_own(*data.CmdLists[i]))
            n = add_calls(p, *data.CmdLists[i], n);
    ink_keep(&p->pen, p->call, n, &p->where);
    for (int i = 0; i < data.CmdListsCount; i++)
        if (!is_own(*data.CmdLists[i]))
            ink_draw(&p->pen, p->call, add_calls(p, *data.CmdLists[i], 0));
}

} // namespace

bool panel_is_built(void)
{
    return true;
}

panel *panel_open(SDL_Window *window, SDL_Renderer *renderer, const panel_host *host)
{
    panel *const p = new (std::nothrow) panel();
    if (!p)
        return nullptr;
    p->host = host;
    p->window = window;
    p->scale = 1;
    p->typing = p->sliding = p->tip = -1;
    p->scene = UINT32_MAX;
    p->groups = panel_groups_of(host, p->group);
    ink_begin(&p->pen, renderer);
    p->imgui = ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    set_style(p);
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
        return !p->hidden && key_event(p, *event);
    case SDL_TEXTINPUT:
        return !p->hidden && text_event(p, *event);
    case SDL_MOUSEMOTION:
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
    case SDL_MOUSEWHEEL:
        return !p->hidden && mouse_event(p, *event);
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:       /* its textures are gone */
        make_letters(p);
        return false;
    default:
        ImGui_ImplSDL2_ProcessEvent(event);
        return false;
    }
}

void panel_draw(panel *p, const SDL_Rect *where)
{
    if (!p)
        return;
    p->hidden = !where;
    give_keys(p);
    if (p->hidden) {
        p->events = 0;
        measure(p, false);
        return;
    }
    p->where = *where;
    p->tip_new = -1;
    feed(p);
    p->on_number = false;
    count_groups(p);
    ImGui_ImplSDL2_NewFrame();
    point(p);
    ImGui::NewFrame();
    p->typing_seen = false;
    show(p);
    if (!p->typing_seen)                /* its row is not there any more */
        p->typing = -1;
    end_sliding(p);
    if (p->tip != p->tip_new)
        p->tip_since = ImGui::GetTime();
    p->tip = p->tip_new;
    ImGui::Render();
    draw(p, *ImGui::GetDrawData());
}

void panel_scale(panel *p, float scale)
{
    if (!p || scale == p->scale || !(scale > 0))
        return;
    p->scale = scale;
    set_style(p);
    make_letters(p);
}

void panel_search(panel *p)
{
    if (!p)
        return;
    p->searching = p->shows_rows = p->keys = true;
    p->asked = 0;
}

bool panel_types(const panel *p)
{
    return p && !p->hidden
        && (p->searching || p->typing >= 0 || ImGui::GetIO().WantTextInput);
}

void panel_close(panel *p)
{
    if (!p)
        return;
    measure(p, false);
    if (ImGui::GetIO().BackendPlatformUserData)
        ImGui_ImplSDL2_Shutdown();
    ink_end(&p->pen);
    ImGui::DestroyContext(p->imgui);
    delete p;
}
