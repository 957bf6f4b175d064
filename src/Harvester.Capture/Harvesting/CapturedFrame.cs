using System;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// One frame, ready to be written: picture, label and mask of one moment. Disposing it lets the picture's buffer be used again.
/// </summary>
public sealed class CapturedFrame : IDisposable
{
    private readonly PixelBufferPool? _pool;
    private bool _disposed;

    /// <summary>Creates a frame from its parts.</summary>
    /// <param name="label">Its label, one line of labels.jsonl.</param>
    /// <param name="picture">Its image.</param>
    /// <param name="mask">Its instance map; null without pixel maps.</param>
    /// <param name="pool">Where the picture's buffer goes back to; null to leave it to the garbage collector.</param>
    public CapturedFrame(FrameLabel label, PixelBuffer picture, InstanceMap? mask, PixelBufferPool? pool = null)
    {
        Label = label;
        Picture = picture;
        Mask = mask;
        _pool = pool;
    }

    /// <summary>Its label, one line of labels.jsonl.</summary>
    public FrameLabel Label { get; }

    /// <summary>Its screenshot; not to be used after disposing.</summary>
    public PixelBuffer Picture { get; }

    /// <summary>Its instance map; null without pixel maps.</summary>
    public InstanceMap? Mask { get; }

    /// <summary>What its labels were made from; null where that is not kept.</summary>
    public RecordedScene? Scene { get; init; }

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
