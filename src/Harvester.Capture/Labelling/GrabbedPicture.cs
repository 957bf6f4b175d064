using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Labelling;

/// <summary>
/// A picture in a buffer of the session's pool, which a screen may still be drawing. Disposing it returns the buffer, unless it was taken.
/// </summary>
internal sealed class GrabbedPicture : IDisposable
{
    private readonly PixelBufferPool _pool;
    private readonly Task? _drawing;
    private PixelBuffer? _buffer;

    /// <summary>Grabs the current picture of a screen; one that can defers drawing it.</summary>
    public GrabbedPicture(IScreen screen, PixelBufferPool pool)
    {
        _pool = pool;
        _buffer = pool.Rent();
        try
        {
            if (screen is IDeferringScreen deferring)
            {
                _drawing = deferring.GrabLater(_buffer);
            }
            else
            {
                Refusal = screen.Grab(_buffer).Refusal;
            }
        }
        catch
        {
            pool.Return(_buffer);
            throw;
        }
    }

    /// <summary>The pool of its buffer.</summary>
    public PixelBufferPool Pool => _pool;

    /// <summary>Why the picture must not be used, as in <see cref="GrabResult.Refusal"/>; null if it can be.</summary>
    public string? Refusal { get; }

    /// <summary>Whether the picture was, or is, drawn by another thread.</summary>
    public bool IsDeferred => _drawing is not null;

    /// <summary>Waits until the picture is drawn, and returns its pixels, which still belong to the picture.</summary>
    /// <exception cref="Exception">The failure of drawing it.</exception>
    public PixelBuffer WaitForPixels()
    {
        _drawing?.GetAwaiter().GetResult();
        return _buffer ?? throw new InvalidOperationException("The picture was taken before.");
    }

    /// <summary>Waits until the picture is drawn, and gives its buffer to the caller. Called once.</summary>
    /// <exception cref="Exception">The failure of drawing it.</exception>
    public PixelBuffer Take()
    {
        _drawing?.GetAwaiter().GetResult();
        PixelBuffer taken = _buffer ?? throw new InvalidOperationException("The picture was taken before.");
        _buffer = null;
        return taken;
    }

    /// <summary>
    /// Has the buffer returned when nothing is drawn into it any more. The failure of drawing an unwanted picture is ignored.
    /// </summary>
    public void Dispose()
    {
        if (_buffer is { } buffer)
        {
            _buffer = null;
            if (_drawing is null)
            {
                _pool.Return(buffer);
            }
            else
            {
                _drawing.ContinueWith(
                    _ => _pool.Return(buffer),
                    CancellationToken.None,
                    TaskContinuationOptions.ExecuteSynchronously,
                    TaskScheduler.Default
                );
            }
        }
    }
}
