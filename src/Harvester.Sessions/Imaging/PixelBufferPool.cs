using System.Collections.Concurrent;
using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging;

/// <summary>A pool of images of one size, so that a harvest does not allocate megabytes per frame. Thread-safe.</summary>
public sealed class PixelBufferPool
{
    private readonly ConcurrentBag<PixelBuffer> _idle = [];
    private readonly ImageSize _size;

    /// <summary>Creates an empty pool.</summary>
    /// <param name="size">Size of its images, pixels.</param>
    public PixelBufferPool(ImageSize size)
    {
        _size = size;
    }

    /// <summary>An image with arbitrary content: a returned one, or a new one.</summary>
    public PixelBuffer Rent() => _idle.TryTake(out PixelBuffer? idle) ? idle : new PixelBuffer(_size);

    /// <summary>Returns an image to the pool; the caller must not use it any more.</summary>
    public void Return(PixelBuffer buffer) => _idle.Add(buffer);
}
