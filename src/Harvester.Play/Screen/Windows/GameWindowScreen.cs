using System.Diagnostics;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen.Windows;

/// <summary>
/// Grabs the client area of a process's main window from the Windows desktop, in physical pixels whatever the display scaling, on any
/// monitor, and scales it to the size of the buffer. The window is found by its process and need not be in the foreground. The picture is
/// stretched to the buffer's size: the camera model accounts for this by the window's aspect ratio in <see
/// cref="CameraIntrinsics.WindowAspect"/>. A picture that does not show the whole window, unchanged from before the copy until after it, is
/// refused with one of <see cref="GrabRefusals"/>. For one thread at a time.
/// </summary>
public sealed class GameWindowScreen : IScreen, IGameWindow, IDisposable
{
    private readonly IDesktop _desktop;
    private readonly int _processId;
    private long _window;
    private ImageSize? _lastSize;
    private PixelBuffer? _picture;
    private ImageScaler? _scaler;

    /// <summary>Grabs the main window of a process.</summary>
    /// <param name="processId">The game's process.</param>
    public GameWindowScreen(int processId)
        : this(new WindowsDesktop(), processId) { }

    internal GameWindowScreen(IDesktop desktop, int processId)
    {
        _desktop = desktop;
        _processId = processId;
    }

    /// <summary>Grabs the main window of the current process, as a mod does.</summary>
    public static GameWindowScreen OfThisProcess()
    {
        using var process = Process.GetCurrentProcess();
        return new GameWindowScreen(process.Id);
    }

    /// <inheritdoc/>
    public GrabResult Grab(PixelBuffer target)
    {
        PixelBuffer wanted = target ?? throw new ArgumentNullException(nameof(target));
        WindowVerdict before = Judge();
        return before.Refusal is null ? GrabClient(before.Client, wanted) : GrabResult.Refused(before.Refusal);
    }

    /// <inheritdoc/>
    public string Describe()
    {
        DesktopView view = _desktop.Observe();
        return WindowJudge.Find(view, _processId, _window) is { } window
            ? WindowDescription.Of(view, window, _desktop.FactsOf(window.Handle))
            : "no window";
    }

    /// <summary>Frees the bitmap into which pixels are copied.</summary>
    public void Dispose() => (_desktop as IDisposable)?.Dispose();

    private GrabResult GrabClient(DesktopRectangle client, PixelBuffer target)
    {
        var size = new ImageSize(client.Width, client.Height);
        bool isResized = _lastSize is { } last && last != size;
        _lastSize = size;
        if (isResized)
        {
            return GrabResult.Refused(GrabRefusals.Resized);
        }

        PixelBuffer picture = PictureOf(size, target);
        if (!_desktop.TryCopy(client, picture))
        {
            return GrabResult.Refused(GrabRefusals.Unreadable);
        }

        if ((ChangeSince(client) ?? PictureJudge.RefusalOf(picture)) is { } refusal)
        {
            return GrabResult.Refused(refusal);
        }

        if (picture != target)
        {
            ScalerOf(size, target.Size).Scale(picture, target);
        }

        return GrabResult.Good;
    }

    private WindowVerdict Judge()
    {
        WindowVerdict verdict = WindowJudge.Judge(_desktop.Observe(), _processId, _window);
        _window = verdict.Window;
        return verdict;
    }

    private string? ChangeSince(DesktopRectangle client)
    {
        WindowVerdict after = Judge();
        if (after.Refusal is not null || after.Client == client)
        {
            return after.Refusal;
        }

        return after.Client.Width == client.Width && after.Client.Height == client.Height ? GrabRefusals.Moved : GrabRefusals.Resized;
    }

    private PixelBuffer PictureOf(ImageSize size, PixelBuffer target)
    {
        if (target.Size == size)
        {
            return target;
        }

        if (_picture?.Size != size)
        {
            _picture = new PixelBuffer(size);
        }

        return _picture!;
    }

    private ImageScaler ScalerOf(ImageSize from, ImageSize to)
    {
        if (_scaler?.Source != from || _scaler.Target != to)
        {
            _scaler = new ImageScaler(from, to);
        }

        return _scaler;
    }
}
