using System.Diagnostics.CodeAnalysis;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The newest frame until the bridge's thread takes it. Two images are swapped, so that none is allocated per frame. If a requested frame
/// is replaced by a newer one, the newer one counts as requested.
/// </summary>
internal sealed class FrameOutbox(ImageSize size)
{
    private readonly object _gate = new();
    private PixelBuffer _waiting = new(size);
    private PixelBuffer _taken = new(size);
    private BridgeState? _state;
    private bool _closed;

    /// <summary>Whether no frame waits.</summary>
    public bool IsEmpty
    {
        get
        {
            lock (_gate)
            {
                return _state is null;
            }
        }
    }

    /// <summary>Stores a frame in place of the one that waits.</summary>
    /// <param name="state">The frame's state.</param>
    /// <param name="picture">The frame's image.</param>
    /// <param name="isStale">Whether it is for a client that is gone; asked in one step with changes by <see cref="Clear"/>.</param>
    /// <returns>Whether the frame was stored; one for a client that is gone is not.</returns>
    /// <exception cref="ArgumentException">The image has another size.</exception>
    public bool Put(BridgeState state, PixelBuffer picture, Func<bool> isStale)
    {
        if (picture.Size != size)
        {
            throw new ArgumentException("The picture is not of the bridge's size.", nameof(picture));
        }

        lock (_gate)
        {
            if (isStale())
            {
                return false;
            }

            if (state.HasPicture)
            {
                Buffer.BlockCopy(picture.Bytes, 0, _waiting.Bytes, 0, picture.Bytes.Length);
            }

            _state = _state is { IsAskedFor: true } ? state with { IsAskedFor = true } : state;
            Monitor.PulseAll(_gate);
            return true;
        }
    }

    /// <summary>Waits for a frame and takes it. The caller may use the image until it takes the next.</summary>
    /// <param name="patience">Maximum time to wait.</param>
    /// <param name="mayGo">Whether a frame may be taken now; one that may not waits until a newer one replaces it.</param>
    /// <param name="state">The frame's state; null if there is no frame.</param>
    /// <param name="picture">The frame's image.</param>
    /// <returns>
    /// False if the outbox is closed, no frame could be taken within the time, or <see cref="Wake"/> ended the wait.
    /// </returns>
    public bool TryTake(
        TimeSpan patience,
        Func<BridgeState, bool> mayGo,
        [NotNullWhen(true)] out BridgeState? state,
        out PixelBuffer picture
    )
    {
        lock (_gate)
        {
            state = Waiting(mayGo);
            if (state is null && !_closed)
            {
                Monitor.Wait(_gate, patience);
                state = Waiting(mayGo);
            }

            if (state is not null)
            {
                (_waiting, _taken) = (_taken, _waiting);
                _state = null;
            }

            picture = _taken;
            return state is not null;
        }
    }

    /// <summary>Makes a waiting thread check again whether the frame may be taken.</summary>
    public void Wake()
    {
        lock (_gate)
        {
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Drops the waiting frame and applies a change of client in one step.</summary>
    public void Clear(Action change)
    {
        lock (_gate)
        {
            change();
            _state = null;
        }
    }

    /// <summary>Ends all waiting for good.</summary>
    public void Close()
    {
        lock (_gate)
        {
            _closed = true;
            Monitor.PulseAll(_gate);
        }
    }

    private BridgeState? Waiting(Func<BridgeState, bool> mayGo) => !_closed && _state is { } state && mayGo(state) ? state : null;
}
