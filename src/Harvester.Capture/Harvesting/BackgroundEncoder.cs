using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Capture.Harvesting;

/// <summary>Encodes pictures one after the other on another thread, and returns their buffers to a pool.</summary>
/// <param name="encoder">Encodes the pictures.</param>
/// <param name="pool">The pool of their buffers.</param>
internal sealed class BackgroundEncoder(PictureEncoder encoder, PixelBufferPool pool)
{
    /// <summary>Number of pictures that may wait, so that memory stays bounded.</summary>
    private const int Capacity = 8;

    private readonly Queue<Task<byte[]>> _waiting = new();
    private Task _last = Task.CompletedTask;

    /// <summary>Whether as many pictures wait as may.</summary>
    public bool IsFull
    {
        get
        {
            while (_waiting.Count > 0 && _waiting.Peek().IsCompleted)
            {
                _waiting.Dequeue();
            }

            return _waiting.Count >= Capacity;
        }
    }

    /// <summary>Waits until the oldest picture is encoded.</summary>
    public void WaitForOldest() => Task.WaitAny(_waiting.Dequeue());

    /// <summary>Encodes a picture, whose buffer belongs to the encoder from now on.</summary>
    public Task<byte[]> Encode(PixelBuffer picture)
    {
        Task<byte[]> made = _last.ContinueWith(
            _ => Encoded(picture),
            CancellationToken.None,
            TaskContinuationOptions.None,
            TaskScheduler.Default
        );
        _last = made;
        _waiting.Enqueue(made);
        return made;
    }

    private byte[] Encoded(PixelBuffer picture)
    {
        try
        {
            using var bytes = new MemoryStream();
            encoder.Write(picture, bytes);
            return bytes.ToArray();
        }
        finally
        {
            pool.Return(picture);
        }
    }
}
