package glint.test;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import glint.android.GlintException;
import glint.android.GlintJob;
import glint.android.GlintLibrary;
import glint.android.GlintRenderOptions;
import glint.android.GlintRenderer;
import glint.android.GlintScene;
import glint.android.GlintStatistics;
import glint.android.GlintView;
import java.io.File;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** The whole interface, used by somebody who writes Java. */
@RunWith(RobolectricTestRunner.class)
public class ConsumerTest {
    @Test
    public void a_picture_in_java() throws Exception {
        final String folder = System.getProperty("glint.scenes");
        try (GlintScene scene = GlintScene.fromFile(new File(folder, "cornell.sdl"));
                GlintRenderer renderer = new GlintRenderer(scene)) {
            assertTrue(scene.getWarnings().isEmpty());
            final ByteBuffer pixels = ByteBuffer.allocateDirect(17 * 5 * 4);
            try (GlintJob job = renderer.start(pixels, 17, 5, new GlintRenderOptions(10))) {
                final GlintStatistics done = job.await();
                assertEquals(17 * 5, done.getPrimaryRays());
            }
            assertEquals(Native.renderHash(folder + "/cornell.sdl", 17, 5, 10, 1), Native.hash(pixels, 17, 5));
            assertEquals(17 * 5, renderer.render(pixels, 17, 5).getPrimaryRays());
        }
        assertEquals(0, GlintLibrary.getOpenHandles());
        assertTrue(GlintLibrary.getInstructionSets().contains("scalar"));
        assertTrue(GlintLibrary.getVersion().matches("\\d+\\.\\d+\\.\\d+"));
    }

    @Test
    public void a_mistake_in_java() {
        final GlintException error = assertThrows(GlintException.class,
                () -> GlintScene.fromBytes("eye".getBytes(StandardCharsets.UTF_8)));
        assertEquals(GlintException.Code.BAD_INPUT, error.getCode());
    }

    @Test
    public void a_view_in_java() {
        final GlintView view = new GlintView(RuntimeEnvironment.getApplication());
        view.setErrorListener(problem -> assertTrue(problem.getMessage(), false));
        view.setScene(null);
        assertEquals(null, view.getFigures());
        view.resetCamera();
        view.frameScene();
        view.trim();
    }
}
