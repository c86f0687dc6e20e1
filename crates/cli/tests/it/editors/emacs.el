;;; Does in Emacs, by Eglot, what a user does with a room in which something does not hold, and writes what there was to see
;;; into the file that SEEN names, as JSON.  BLOCK names the set-up of docs/editors.md.  -*- lexical-binding: t -*-

(require 'package)
(package-initialize)
(load (getenv "BLOCK") nil t t)
(require 'json)
(require 'flymake)
(setq eglot-sync-connect 60 eglot-connect-timeout 60 eglot-send-changes-idle-time 0 eglot-confirm-server-edits nil
      flymake-no-changes-timeout 0 make-backup-files nil create-lockfiles nil)
;; Whether the server may change the layout.
(fset 'y-or-n-p (lambda (&rest _) t))

(defvar seen nil)
(defun saw (key value) (push (cons key value) seen))

(defun wait (what ask)
  "Wait until the function ASK has an answer, and return it."
  (let ((end (+ (float-time) 60)) answer)
    (while (and (not (setq answer (funcall ask))) (< (float-time) end))
      (accept-process-output nil 0.02)
      (sit-for 0.01))
    (or answer (error "Waited in vain for %s" what))))

(defun marked ()
  "What is marked: pairs of line and message."
  (mapcar (lambda (found)
            (list (cons 'line (line-number-at-pos (flymake-diagnostic-beg found)))
                  (cons 'text (buffer-substring-no-properties (flymake-diagnostic-beg found) (flymake-diagnostic-end found)))
                  (cons 'message (flymake-diagnostic-text found))))
          (flymake-diagnostics)))

(defun fails-p ()
  (seq-find (lambda (found) (string-search "must be at least" (flymake-diagnostic-text found))) (flymake-diagnostics)))

(condition-case trouble
    (with-current-buffer (find-file-noselect "room.scene")
      (switch-to-buffer (current-buffer))
      (saw 'version emacs-version)
      (saw 'mode (symbol-name major-mode))
      ;; What comes after a command in an editor that somebody sits at.
      (run-hooks 'post-command-hook)
      (wait "a server" #'eglot-current-server)
      (wait "a squiggle" (lambda () (flymake-start) (fails-p)))
      (saw 'marked (vconcat (marked)))
      (goto-char (point-min))
      (search-forward "object b")
      (let ((said nil))
        (run-hook-with-args 'eldoc-documentation-functions (lambda (text &rest _) (push (format "%s" text) said)))
        (saw 'hover (wait "a hover" (lambda () (seq-find (lambda (text) (string-search "Where one sleeps" text)) said)))))
      (goto-char (point-min))
      (search-forward "assert gap")
      (let* ((actions (append (eglot-code-actions (point)) nil))
             (repair (seq-find (lambda (action) (equal (plist-get action :title) "Repair this constraint")) actions)))
        (saw 'menu (vconcat (mapcar (lambda (action) (plist-get action :title)) actions)))
        (if (fboundp 'eglot-execute)
            (eglot-execute (eglot-current-server) repair)
          ;; Before Eglot 1.16 actions are not completed, so they are commands.
          (let ((command (plist-get repair :command)))
            (eglot-execute-command (eglot-current-server) (intern (plist-get command :command)) (plist-get command :arguments))))
        (save-some-buffers t)
        (wait "the repair" (lambda () (not (fails-p)))))
      (saw 'repaired (vconcat (marked)))
      (goto-char (point-min))
      (search-forward "object b")
      (eglot-rename "couch")
      (save-some-buffers t))
  (error (saw 'trouble (format "%S" trouble))))

(with-temp-file (getenv "SEEN") (insert (json-encode seen)))
(kill-emacs 0)
