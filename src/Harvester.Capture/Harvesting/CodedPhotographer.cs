using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Geometry.PixelMaps.Screens;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Takes the photographs for a coded mask while the game is frozen. How late visibility takes effect is measured once, by hiding all
/// objects of a frame and waiting for the picture to change. If it does not change in several frames, coded masks are given up. Whether
/// the game draws screens is tried once, too; if it does not, objects are hidden by code words instead.
/// </summary>
/// <param name="game">The game.</param>
/// <param name="pool">Buffers for the pictures.</param>
/// <param name="maxTicks">Maximum lag of a picture, ticks; a change is waited for that much longer.</param>
internal sealed class CodedPhotographer(GamePorts game, PixelBufferPool pool, int maxTicks)
{
    /// <summary>Visibility that takes longer than this many ticks is not waited for.</summary>
    private const int MaxDelayTicks = 20;

    /// <summary>Number of frames without any change after which coded masks are given up: all objects of a frame may be hidden.</summary>
    private const int MaxFailures = 3;

    /// <summary>A picture is waited for one tick longer than measured.</summary>
    private const int SpareTicks = 1;

    /// <summary>A pixel has changed if a channel differs by more than this many grey levels: far more than noise.</summary>
    private const int ChangedLevels = 30;

    /// <summary>So many changed pixels more than between two equal pictures are a change.</summary>
    private const int ChangedPixels = 12;

    private readonly List<PixelBuffer> _buffers = [];
    private int? _delay;
    private bool? _showsScreens;
    private int _noise;
    private int _failures;
    private int _screenFailures;
    private bool _isHiding;

    /// <summary>The pictures of the last frame; null if there are none.</summary>
    public CodedPictures? Pictures { get; private set; }

    /// <summary>Why the last frame must be discarded; null if it can be used.</summary>
    public string? Refusal { get; private set; }

    /// <summary>Why masks come from rays although others were asked for; null if they do not.</summary>
    public CaptureFault? Warning { get; private set; }

    /// <summary>Takes the pictures of a frame. <see cref="Release"/> must be called afterwards, whatever happens.</summary>
    /// <param name="camera">The camera of the frame.</param>
    /// <param name="targets">The objects of the frame.</param>
    /// <param name="picture">The picture with all objects; null for a frame of another shard, for which only time passes.</param>
    public IEnumerable<WorkStep> Take(Camera camera, IReadOnlyList<MapTarget> targets, PixelBuffer? picture)
    {
        Refusal = null;
        if (Warning is not null || targets.Count == 0)
        {
            yield break;
        }

        if (game.Visibility is not { } visibility)
        {
            Warning = Unhidden("the game offers no way to hide objects");
            yield break;
        }

        _isHiding = true;
        IReadOnlyCollection<int>? hideable;
        while ((hideable = visibility.Announce([.. targets.Select(target => target.Entity)])) is null)
        {
            yield return WorkStep.Tick;
        }

        var allowed = new HashSet<int>(hideable);
        MapTarget[] hidden = [.. targets.Where(target => allowed.Contains(target.Entity))];
        if (hidden.Length == 0)
        {
            yield break;
        }

        if (_delay is null)
        {
            yield return WorkStep.Do(MeasureDelay(visibility, hidden, picture ?? Grab()));
        }

        if (_delay is { } delay && Refusal is null)
        {
            var screens = ScreenPlan.For(camera, hidden);
            if (_showsScreens is null && game.Sheets is { } sheets)
            {
                yield return WorkStep.Do(TryScreens(sheets, screens, hidden, picture ?? Grab(), delay + SpareTicks));
            }

            IPicturePlan plan = _showsScreens == true ? screens : VisibilityCode.For(camera, hidden);
            yield return WorkStep.Do(Photograph(visibility, plan, hidden, picture, delay + SpareTicks));
        }
    }

    /// <summary>Shows everything again and returns the buffers. Calling it again has no effect.</summary>
    public void Release()
    {
        Pictures = null;
        foreach (PixelBuffer buffer in _buffers)
        {
            pool.Return(buffer);
        }

        _buffers.Clear();
        if (_isHiding)
        {
            try
            {
                game.Visibility?.ShowAll();
                _isHiding = false;
            }
            finally
            {
                game.Sheets?.Clear();
            }
        }
    }

    /// <summary>Takes the pictures of a plan, and waits for each.</summary>
    private IEnumerable<WorkStep> Photograph(IVisibility visibility, IPicturePlan plan, MapTarget[] hidden, PixelBuffer? picture, int ticks)
    {
        var pictures = new List<byte[]>();
        for (int number = 0; number < plan.PictureCount && Refusal is null; number++)
        {
            if (number == 0 && picture is not null)
            {
                pictures.Add(picture.Bytes);
                continue;
            }

            if (picture is not null)
            {
                int shown = number;
                visibility.HideOnly([.. hidden.Where((_, index) => !plan.IsShown(shown, index)).Select(target => target.Entity)]);
                game.Sheets?.Show(plan.Sheets(number));
            }

            for (int tick = 0; number > 0 && tick < ticks; tick++)
            {
                yield return WorkStep.Tick;
            }

            if (picture is not null)
            {
                pictures.Add(Grab().Bytes);
            }
        }

        // Everything is back before rays are cast and the scene is read again.
        visibility.HideOnly([]);
        game.Sheets?.Clear();
        for (int tick = 0; tick < ticks; tick++)
        {
            yield return WorkStep.Tick;
        }

        Pictures = picture is null || Refusal is not null ? null : new CodedPictures(hidden, plan, pictures);
    }

    /// <summary>Shows the screens of all objects and looks whether the picture changes.</summary>
    private IEnumerable<WorkStep> TryScreens(ISheets sheets, ScreenPlan plan, MapTarget[] targets, PixelBuffer before, int ticks)
    {
        sheets.Show([.. Enumerable.Range(0, plan.PictureCount).SelectMany(plan.Sheets)]);
        for (int tick = 0; tick < ticks; tick++)
        {
            yield return WorkStep.Tick;
        }

        bool isChanged = ChangesBetween(before, Grab(), targets) > (2 * _noise) + ChangedPixels;
        sheets.Clear();
        _showsScreens =
            isChanged ? true
            : ++_screenFailures == MaxFailures ? false
            : null;
    }

    private static CaptureFault Unhidden(string why) => new(FaultCode.NothingHidden, $"Masks come from rays: {why}.");

    /// <summary>Hides everything, waits until the picture changes, and shows everything again.</summary>
    private IEnumerable<WorkStep> MeasureDelay(IVisibility visibility, MapTarget[] targets, PixelBuffer before)
    {
        yield return WorkStep.Tick;
        _noise = ChangesBetween(before, Grab(), targets);
        visibility.HideOnly([.. targets.Select(target => target.Entity)]);
        int most = MaxDelayTicks + maxTicks;
        int ticks = 0;
        bool isChanged = false;
        while (!isChanged && ticks < most && Refusal is null)
        {
            yield return WorkStep.Tick;
            ticks++;
            PixelBuffer now = Grab();
            isChanged = ChangesBetween(before, now, targets) > (2 * _noise) + ChangedPixels;
            _buffers.Remove(now);
            pool.Return(now);
        }

        visibility.HideOnly([]);
        if (isChanged)
        {
            _delay = ticks;
        }
        else if (Refusal is null && ++_failures == MaxFailures)
        {
            Warning = Unhidden($"hidden objects still show in the picture of the frozen game after {most} ticks");
        }

        // What was hidden comes back as late as it went.
        for (int tick = 0; tick < ticks + SpareTicks; tick++)
        {
            yield return WorkStep.Tick;
        }
    }

    private PixelBuffer Grab()
    {
        PixelBuffer buffer = pool.Rent();
        _buffers.Add(buffer);
        Refusal ??= game.Screen.Grab(buffer).Refusal;
        return buffer;
    }

    /// <summary>Number of pixels in the boxes of targets that differ clearly.</summary>
    private static int ChangesBetween(PixelBuffer a, PixelBuffer b, MapTarget[] targets)
    {
        int width = a.Size.Width;
        var counted = new bool[a.Size.PixelCount];
        int changes = 0;
        foreach (MapTarget target in targets)
        {
            if (target.Projection.Box is not { } box)
            {
                continue;
            }

            int bottom = Math.Min(a.Size.Height, (int)Math.Ceiling(box.YMax));
            int right = Math.Min(width, (int)Math.Ceiling(box.XMax));
            for (int row = Math.Max(0, (int)box.YMin); row < bottom; row++)
            {
                for (int pixel = (row * width) + Math.Max(0, (int)box.XMin); pixel < (row * width) + right; pixel++)
                {
                    changes += !counted[pixel] && IsChanged(a.Bytes, b.Bytes, 3 * pixel) ? 1 : 0;
                    counted[pixel] = true;
                }
            }
        }

        return changes;
    }

    private static bool IsChanged(byte[] a, byte[] b, int first) =>
        Math.Abs(a[first] - b[first]) > ChangedLevels
        || Math.Abs(a[first + 1] - b[first + 1]) > ChangedLevels
        || Math.Abs(a[first + 2] - b[first + 2]) > ChangedLevels;
}
