using System.Numerics;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>
/// Draws pictures of moments, one at a time: at once, or on another thread while the world moves on. A picture depends on its moment and
/// on the static world only. All calls come from one thread.
/// </summary>
/// <param name="world">The scene whose static part is drawn.</param>
/// <param name="detail">How much of the light is shown.</param>
/// <param name="noise">What changes from picture to picture.</param>
internal sealed class PicturePainter(RenderScene world, Detail detail, PictureNoise noise)
{
    private readonly Renderer _renderer = new(detail);
    private RenderTarget? _picture;
    private long _state = -1;
    private Task _last = Task.CompletedTask;

    /// <summary>Draws a moment, with the handle and depth of each pixel. The result is overwritten by the next picture.</summary>
    public RenderTarget Paint(Moment moment, ImageSize size)
    {
        // A failure of an earlier picture belongs to the caller that grabbed it.
        Task.WaitAny(_last);
        return PaintNow(moment, moment.SceneIn(world), size);
    }

    /// <summary>Draws a moment; see <see cref="Renderer.NormalsOfLast"/>.</summary>
    public Vector3[] Normals(Moment moment, ImageSize size)
    {
        Paint(moment, size);
        return _renderer.NormalsOfLast();
    }

    /// <summary>Draws a moment on another thread, after the pictures that were asked for before.</summary>
    /// <returns>Ends when the picture is drawn, or with the failure of drawing it.</returns>
    public Task PaintLater(Moment moment, PixelBuffer target)
    {
        RenderScene scene = moment.SceneIn(world);
        _last = _last.ContinueWith(_ => Copy(PaintNow(moment, scene, target.Size), moment, target), TaskScheduler.Default);
        return _last;
    }

    /// <summary>Draws a moment as the game's screen shows it, with noise.</summary>
    public void Show(Moment moment, PixelBuffer target) => Copy(Paint(moment, target.Size), moment, target);

    private void Copy(RenderTarget picture, Moment moment, PixelBuffer target)
    {
        if (noise.IsAny)
        {
            noise.Apply(picture, CameraOf(moment, target.Size), moment.Truth.GameFrame, target);
            return;
        }

        Buffer.BlockCopy(picture.Colour, 0, target.Bytes, 0, target.Bytes.Length);
    }

    private static RenderCamera CameraOf(Moment moment, ImageSize size)
    {
        CameraState camera = moment.Truth.Camera;
        return new RenderCamera(camera.Pose, camera.VerticalFovDegrees, camera.WindowAspect, camera.NearClip, size.Width, size.Height)
        {
            Lens = moment.Lens,
        };
    }

    private RenderTarget PaintNow(Moment moment, RenderScene scene, ImageSize size)
    {
        if (_picture is null || _picture.Width != size.Width || _picture.Height != size.Height)
        {
            _picture = new RenderTarget(size.Width, size.Height);
            _state = -1;
        }

        if (_state != moment.State)
        {
            _state = -1;
            _renderer.Render(scene, CameraOf(moment, size), _picture);
            _state = moment.State;
        }

        return _picture;
    }
}
