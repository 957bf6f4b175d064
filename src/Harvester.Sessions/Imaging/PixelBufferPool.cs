using System.Collections.Concurrent;
using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging;

/// <summary>
/// Pictures of one size that are used again and again, so that a harvest makes no garbage of megabytes. Safe for several threads.
/// </summary>
public sealed class PixelBufferPool
{
    private readonly ConcurrentBag<PixelBuffer> _idle = [];
    private readonly ImageSize _size;

    /// <summary>Makes an empty pool.</summary>
    /// <param name="size">Size of its pictures, pixels.</param>
    public PixelBufferPool(ImageSize size)
    {
        _size = size;
    }

    /// <summary>A picture with any content: one that was returned, or a new one.</summary>
    public PixelBuffer Rent() => _idle.TryTake(out PixelBuffer? idle) ? idle : new PixelBuffer(_size);

    /// <summary>Gives a picture back; whoever returns it does not use it any more.</summary>
    public void Return(PixelBuffer buffer) => _idle.Add(buffer);
}
