# SPDX-License-Identifier: MIT
# Installs the program, the libraries and their headers, and the scenes.

# Files by which other builds find the installed library, as in CMakeLists.txt.
PACKAGES := $(addprefix cmake/tidepool/tidepool-,config.cmake config-version.cmake) \
            pkgconfig/tidepool.pc pkgconfig/tidepool-host.pc
PACKAGED = -e 's|@TP_PREFIX@|../..|; s|@TP_LIBDIR@|lib|; s|@TP_INCLUDEDIR@|include|' \
           -e "s|@TP_VERSION@|$$(sed -n 's/^.define TP_VERSION_M[AI].* //p; \
               s/^.define TP_VERSION_PATCH *//p' include/tidepool/*.h | paste -sd.)|"

install:
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/lib
	install $(PROGRAM) $(DESTDIR)$(PREFIX)/bin
	install -m 644 $(LIB) $(HOST_LIB) $(DESTDIR)$(PREFIX)/lib
	for f in include/tidepool/*.h ports/library/tidepool/*.h; do \
	    install -Dm 644 $$f $(DESTDIR)$(PREFIX)/include/tidepool/$${f##*/} || exit 1; \
	done
	for f in $(PACKAGES); do \
	    to=$(DESTDIR)$(PREFIX)/lib/$$f && install -Dm 644 /dev/null $$to && \
	    sed $(PACKAGED) ports/packages/$${f##*/}.in >$$to || exit 1; \
	done
	for f in 'manual=man/man1/tidepool.1' 'manual --scene=man/man5/tidepool-scene.5' \
	        'completion bash=bash-completion/completions/tidepool' \
	        'completion zsh=zsh/site-functions/_tidepool' \
	        'completion fish=fish/vendor_completions.d/tidepool.fish'; do \
	    to=$(DESTDIR)$(PREFIX)/share/$${f##*=} && install -Dm 644 /dev/null $$to && \
	    $(PROGRAM) $${f%=*} >$$to || exit 1; \
	done
	for f in $(SHIPPED); do \
	    install -Dm 644 $$f $(DESTDIR)$(PREFIX)/share/tidepool/$${f#assets/}; done
