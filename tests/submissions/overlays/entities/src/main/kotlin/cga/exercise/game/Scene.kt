package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.engine.EventBus
import cga.exercise.engine.Frame
import cga.exercise.engine.MouseMoved
import cga.exercise.engine.Renderer
import cga.exercise.engine.SceneReader
import cga.exercise.engine.Tick
import cga.framework.GLError
import cga.framework.GameWindow
import org.lwjgl.opengl.GL11.*

class Scene(window: GameWindow) {
    private val bus = EventBus()
    private val renderer: Renderer
    private var mouse: Pair<Double, Double>? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)

        val scene = SceneReader().read(SCENE_TEXT)
        val camera = TronCamera()
        camera.parent = scene.entity("eye").node
        renderer = Renderer(scene.root, camera)

        PulseSystem(scene.root, bus)
        OrbitSystem(scene.entity("boom"), bus)
        DriveSystem(window, scene.entity("motorcycle"), bus)
        GLError.checkThrow("after the scene was read")
    }

    fun update(dt: Float, t: Float) = bus.post(Tick(dt, t))

    fun render(dt: Float, t: Float) {
        bus.post(Frame(t))
        renderer.render()
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        mouse?.let { (x, y) -> bus.post(MouseMoved(xpos - x, ypos - y)) }
        mouse = xpos to ypos
    }

    fun cleanup() = renderer.cleanup()
}
