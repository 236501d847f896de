package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    // Blatt 1
    // private val meshHaus: Mesh
    // private val meshInitialen: Mesh
    // Blatt 2
    // private val sphere: Renderable

    private val ground = Renderable()
    private val motorrad: Renderable
    private val camera = TronCamera()

    // Blatt 4
    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val eckeRot: PointLight
    private val eckeBlau: PointLight
    private val eckeGelb: PointLight
    private val eckeLila: PointLight

    private var motorradFarbe = Vector3f(1.0f, 0.0f, 0.0f)

    private var alteMausX = 0.0
    private var ersteMausBewegung = true

    //scene setup
    init {
        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val groundRes = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attr0 = VertexAttribute(3, 8 * 4, 0)
        val attr1 = VertexAttribute(2, 8 * 4, 3 * 4)
        val attr2 = VertexAttribute(3, 8 * 4, 5 * 4)
        val vertexAttributes = arrayOf(attr0, attr1, attr2)

        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)

        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f, 64.0f))
        ground.meshes.add(Mesh(groundRes.vertexData, groundRes.indexData, vertexAttributes, groundMaterial))

        // sphere.scaleLocal(Vector3f(0.5f))
        // sphere.rotateLocal(Math.toRadians(90.0f), 0.0f, 0.0f)

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorrad.scaleLocal(Vector3f(0.8f))

        // Kamera
        camera.parent = motorrad
        camera.rotateLocal(Math.toRadians(-35.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.0f))

        // 4.2 Punktlicht
        pointLight = PointLight(Vector3f(0.0f, 1.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        pointLight.translateLocal(Vector3f(0.0f, 0.8f, 0.3f))
        pointLight.parent = motorrad

        // 4.3 Scheinwerfer
        spotLight = SpotLight(
            Vector3f(0.0f, 1.0f, -2.0f),
            Vector3f(3.0f, 3.0f, 3.0f),
            Math.toRadians(15.0f),
            Math.toRadians(30.0f)
        )
        spotLight.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        spotLight.parent = motorrad

        // 4.6 Ecken
        eckeRot = PointLight(Vector3f(-20.0f, 2.0f, -20.0f), Vector3f(10.0f, 0.0f, 0.0f))
        eckeBlau = PointLight(Vector3f(20.0f, 2.0f, -20.0f), Vector3f(0.0f, 0.0f, 10.0f))
        eckeGelb = PointLight(Vector3f(20.0f, 2.0f, 20.0f), Vector3f(9.0f, 8.0f, 0.0f))
        eckeLila = PointLight(Vector3f(-20.0f, 2.0f, 20.0f), Vector3f(7.0f, 0.0f, 9.0f))

        GLError.checkThrow()
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        camera.bind(staticShader)

        // 4.4 Farbe abhängig von der Zeit
        motorradFarbe = Vector3f(Math.abs(Math.sin(t)), Math.abs(Math.sin(t / 2.0f)), Math.abs(Math.sin(t / 3.0f)))
        pointLight.lightColor = motorradFarbe

        // erst die Lichter, dann die Objekte!
        pointLight.bind(staticShader, "pointLight")
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())
        eckeRot.bind(staticShader, "eckeRot")
        eckeBlau.bind(staticShader, "eckeBlau")
        eckeGelb.bind(staticShader, "eckeGelb")
        eckeLila.bind(staticShader, "eckeLila")

        staticShader.setUniform("farbe", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(staticShader)
        staticShader.setUniform("farbe", motorradFarbe)
        motorrad.render(staticShader)
        // sphere.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        // Turbo
        var tempo = 5.0f
        if (window.getKeyState(GLFW_KEY_SPACE)) tempo = 12.0f

        if (window.getKeyState(GLFW_KEY_W)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -tempo * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, -1.5f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, tempo * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, 1.5f * dt, 0.0f)
        }
        // println("Licht: " + pointLight.getWorldPosition())
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteMausBewegung) {
            alteMausX = xpos
            ersteMausBewegung = false
        }
        val deltaX = (alteMausX - xpos).toFloat()
        alteMausX = xpos
        // println("deltaX = $deltaX")
        camera.rotateAroundPoint(0.0f, deltaX * 0.002f, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
