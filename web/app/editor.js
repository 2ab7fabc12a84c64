// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The text of a BRDF: a text area with the numbers of its lines, one of which may be marked.

export class Editor {
  #text;
  #lines;
  #bad = 0;
  #leaving = false;

  /// `changed` is called with the text whenever it is typed in.
  constructor(text, lines, changed) {
    this.#text = text;
    this.#lines = lines;
    text.addEventListener('input', () => {
      this.mark(0);
      changed(text.value);
    });
    text.addEventListener('scroll', () => lines.scrollTop = text.scrollTop);
    text.addEventListener('keydown', (event) => this.#key(event));
    this.#number();
  }

  get value() { return this.#text.value; }
  set value(value) {
    this.#text.value = value;
    this.mark(0);
  }

  /// Marks a line, 1 the first; 0 none.
  mark(line) {
    this.#bad = line;
    this.#text.setAttribute('aria-invalid', String(line > 0));
    this.#number();
    if (line === 0) return;
    const height = 20, {clientHeight, scrollTop} = this.#text, at = (line - 1) * height;
    if (at < scrollTop || at > scrollTop + clientHeight - 2 * height) this.#text.scrollTop = at - clientHeight / 2;
  }

  #number() {
    const count = this.#text.value.split('\n').length;
    this.#lines.replaceChildren(...Array.from({length: count}, (_, i) => {
      const line = document.createElement('span');
      line.textContent = `${i + 1}\n`;
      if (i + 1 === this.#bad) line.className = 'bad';
      return line;
    }));
    this.#lines.scrollTop = this.#text.scrollTop;
  }

  // Tab indents, unless Escape was pressed before: who has no mouse gets out.
  #key(event) {
    if (event.key === 'Escape') {
      this.#leaving = true;
    } else if (event.key === 'Tab' && !event.shiftKey && !this.#leaving) {
      event.preventDefault();
      this.#text.setRangeText('  ', this.#text.selectionStart, this.#text.selectionEnd, 'end');
      this.#text.dispatchEvent(new Event('input'));
    } else if (event.key !== 'Shift') {
      this.#leaving = false;
    }
  }
}
