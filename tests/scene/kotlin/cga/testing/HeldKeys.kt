package cga.testing

import cga.framework.WindowState

/** A window of 1280×720 on whose keyboard [keys] are held down. */
class HeldKeys(vararg keys: Int) : WindowState {
    val keys = keys.toMutableSet()
    override val framebufferWidth = 1280
    override val framebufferHeight = 720

    override fun getKeyState(key: Int): Boolean = key in keys
}
