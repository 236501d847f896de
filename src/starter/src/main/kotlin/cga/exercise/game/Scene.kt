package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
// solution
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
// end of solution
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
// solution
import kotlin.math.abs
import kotlin.math.sin
// end of solution

class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = Renderable()
    private val motorcycle: Renderable
    private val camera = TronCamera()

    // solution
    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val cornerLights: List<PointLight>
    private var oldMouseX = Double.NaN
    // end of solution

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        val groundMaterial = Material(
            loadTexture("assets/ground/ground_diffuse.png"),
            loadTexture("assets/ground/ground_emissive.png"),
            loadTexture("assets/ground/ground_specular.png"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        val groundModel = OBJLoader.loadOBJ("assets/ground/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        ground.meshes.add(Mesh(groundModel.vertexData, groundModel.indexData, attributes, groundMaterial))

        motorcycle = ModelLoader.loadModel("assets/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalArgumentException("the motorcycle could not be loaded")
        motorcycle.scaleLocal(Vector3f(0.8f))

        camera.parent = motorcycle
        camera.rotateLocal(toRadians(-35.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        // solution 4.2.2: a point light, child of the motorcycle, high enough to light the ground; bind it in render()
        // Lösung 4.2.2: ein Punktlicht, Child des Motorrads, hoch genug, um den Boden anzustrahlen; in render() wird es gebunden
        // solution 4.3.2: a spotlight at the front of the motorcycle, turned down a little; bind it as well
        // Lösung 4.3.2: ein Spotlight vorne am Motorrad, leicht nach unten geneigt; auch dieses wird gebunden
        // solution 4.6: more point lights of different colours, for example in the corners of the ground
        // Lösung 4.6: weitere Punktlichter in verschiedenen Farben, zum Beispiel in den Ecken des Bodens
        pointLight = PointLight(Vector3f(0.0f, 1.6f, 0.0f), Vector3f(1.0f))
        pointLight.parent = motorcycle

        spotLight = SpotLight(Vector3f(0.0f, 0.9f, -1.6f), Vector3f(5.0f, 5.0f, 4.5f), toRadians(7.0f), toRadians(24.0f))
        spotLight.rotateLocal(toRadians(-4.0f), 0.0f, 0.0f)
        spotLight.parent = motorcycle

        cornerLights = listOf(
            PointLight(Vector3f(-16.0f, 1.2f, -16.0f), Vector3f(16.0f, 1.0f, 0.5f)),
            PointLight(Vector3f(16.0f, 1.2f, -16.0f), Vector3f(0.5f, 2.0f, 16.0f)),
            PointLight(Vector3f(-16.0f, 1.2f, 16.0f), Vector3f(14.0f, 9.0f, 0.5f)),
            PointLight(Vector3f(16.0f, 1.2f, 16.0f), Vector3f(13.0f, 0.5f, 10.0f))
        )
        // end of solution
        GLError.checkThrow("in Scene.init")
    }

    private fun loadTexture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        camera.bind(staticShader)

        // solution
        val motorcycleColor = Vector3f(abs(sin(t)), abs(sin(t / 2)), abs(sin(t / 3)))
        pointLight.lightColor = motorcycleColor
        pointLight.bind(staticShader, "pointLight[0]")
        for ((i, light) in cornerLights.withIndex()) light.bind(staticShader, "pointLight[${i + 1}]")
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())
        // end of solution

        // solution 4.4: send the ground's colour before it is drawn, then the motorcycle's, which changes with t as its point light's does
        // Lösung 4.4: Übertragen Sie vor dem Zeichnen die Farbe des Bodens, dann die des Motorrads, die sich wie sein Punktlicht mit t ändert
        // instead: ground.render(staticShader)
        // instead: motorcycle.render(staticShader)
        staticShader.setUniform("tint", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)
        staticShader.setUniform("tint", motorcycleColor)
        motorcycle.render(staticShader)
        // end of solution
    }

    fun update(dt: Float, t: Float) {
        val speed = when {
            window.getKeyState(GLFW_KEY_W) -> 4.0f
            window.getKeyState(GLFW_KEY_S) -> -4.0f
            else -> 0.0f
        }
        if (speed == 0.0f) return
        val turn = 1.5f * dt * (if (speed > 0) 1 else -1)
        if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, turn, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -turn, 0.0f)
        // In its own space, which is scaled.
        motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt / 0.8f))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        // solution 4.5: turn the camera about the motorcycle, 0.002 rad for each pixel that the mouse has moved in x
        // Lösung 4.5: Drehen Sie die Kamera um das Motorrad, 0.002 rad je Pixel, um den sich die Maus in x bewegt hat
        val pixels = if (oldMouseX.isNaN()) 0.0 else xpos - oldMouseX
        oldMouseX = xpos
        camera.rotateAroundPoint(0.0f, (0.002 * pixels).toFloat(), 0.0f, Vector3f(0.0f))
        // end of solution
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
