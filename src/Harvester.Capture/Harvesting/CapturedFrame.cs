using System;
using System.Collections.Generic;
using Harvester.Capture.Labelling;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// One frame, ready to be written: image, label and mask of one moment. Disposing it returns the image's buffer to the pool.
/// </summary>
public sealed class CapturedFrame : IDisposable
{
    private readonly PixelBufferPool? _pool;
    private bool _disposed;

    /// <summary>Creates a frame from its parts.</summary>
    /// <param name="label">Its label, one line of labels.jsonl.</param>
    /// <param name="picture">Its image.</param>
    /// <param name="mask">Its instance map; null without pixel maps.</param>
    /// <param name="pool">The pool to which the image's buffer returns; null if it came from none.</param>
    public CapturedFrame(FrameLabel label, PixelBuffer picture, InstanceMap? mask, PixelBufferPool? pool = null)
    {
        Label = label;
        Picture = picture;
        Mask = mask;
        _pool = pool;
    }

    /// <summary>Its label, one line of labels.jsonl.</summary>
    public FrameLabel Label { get; private set; }

    /// <summary>Its image; not to be used after disposing.</summary>
    public PixelBuffer Picture { get; }

    /// <summary>Its instance map; null without pixel maps.</summary>
    public InstanceMap? Mask { get; }

    /// <summary>Its class map; null without one.</summary>
    public InstanceMap? Classes { get; init; }

    /// <summary>Its depth maps; null without any.</summary>
    public DepthMaps? Depth { get; init; }

    /// <summary>The points of the LiDARs, in the order of the label; empty except for the first view of a moment.</summary>
    public IReadOnlyList<LidarSweep> Sweeps { get; init; } = [];

    /// <summary>The bytes of the files of further pictures, in the order of those in the label that have a file.</summary>
    public IReadOnlyList<byte[]> Pairs { get; init; } = [];

    /// <summary>The scene from which its labels were made; null if scenes are not recorded.</summary>
    public RecordedScene? Scene { get; init; }

    /// <summary>Adds to the label what is known only later: the action that answered the frame, and the motion up to the frame.</summary>
    public void Attach(DriveLabel drive, IReadOnlyList<MotionSample> motion) => Label = Label with { Drive = drive, Motion = motion };

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
