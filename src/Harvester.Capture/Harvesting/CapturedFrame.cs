using Harvester.Capture.Events;
using Harvester.Capture.Labelling;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Events;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// One frame, ready to be written: image, label, mask and what the channels found, all of one moment. Disposing it returns the image's
/// buffer to the pool.
/// </summary>
public sealed class CapturedFrame : IDisposable
{
    private readonly PixelBufferPool? _pool;
    private bool _disposed;

    /// <summary>Creates a frame.</summary>
    /// <param name="label">Its label, one line of labels.jsonl.</param>
    /// <param name="picture">Its image.</param>
    /// <param name="pool">The pool to which the image's buffer returns; null if it came from none.</param>
    public CapturedFrame(FrameLabel label, PixelBuffer picture, PixelBufferPool? pool = null)
    {
        Label = label;
        Picture = picture;
        _pool = pool;
    }

    /// <summary>Its label, one line of labels.jsonl.</summary>
    public FrameLabel Label { get; private set; }

    /// <summary>Its image; not to be used after disposing.</summary>
    public PixelBuffer Picture { get; }

    /// <summary>Its instance map; null without pixel maps.</summary>
    public InstanceMap? Mask { get; init; }

    /// <summary>What its channels have found, in the order of the label.</summary>
    public IReadOnlyList<FramePart> Parts { get; init; } = [];

    /// <summary>The files of its channels, in the order of the label.</summary>
    public IReadOnlyList<FrameFile> Files { get; init; } = [];

    /// <summary>The folders that hold files of this frame alone.</summary>
    public IReadOnlyList<string> Folders { get; init; } = [];

    /// <summary>The scene from which its labels were made; null if scenes are not recorded.</summary>
    public RecordedScene? Scene { get; init; }

    /// <summary>The events that have ended since the frame before; all their frames come before this one.</summary>
    public IReadOnlyList<DrivingEvent> EndedEvents { get; internal set; } = [];

    /// <summary>The events that are open at its moment or have ended since the frame before, with their times.</summary>
    internal IReadOnlyList<EventSpan> Events { get; init; } = [];

    /// <summary>What one channel has found; null if that is nothing.</summary>
    public T? Part<T>()
        where T : FramePart => Parts.OfType<T>().FirstOrDefault();

    /// <summary>Adds to the label what is known only later: the action that answered the frame, and the motion up to the frame.</summary>
    public void Attach(DriveLabel drive, IReadOnlyList<MotionSample> motion) => Label = Label with { Drive = drive, Motion = motion };

    /// <summary>Adds events that ended before its own, which an earlier frame had that was dropped.</summary>
    internal void Bring(IReadOnlyList<DrivingEvent> earlier) => EndedEvents = [.. earlier, .. EndedEvents];

    /// <inheritdoc />
    public void Dispose()
    {
        if (!_disposed)
        {
            _disposed = true;
            _pool?.Return(Picture);
        }
    }
}
