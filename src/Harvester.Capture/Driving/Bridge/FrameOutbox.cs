using System;
using System.Diagnostics.CodeAnalysis;
using System.Threading;
using Harvester.Capture.Imaging;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Driving.Bridge;

/// <summary>The newest frame until the bridge's thread takes it. Two pictures go back and forth, so that nothing is allocated a frame.</summary>
internal sealed class FrameOutbox(ImageSize size)
{
    private readonly object _gate = new();
    private PixelBuffer _waiting = new(size);
    private PixelBuffer _taken = new(size);
    private BridgeState? _state;
    private bool _closed;

    /// <summary>Puts a frame in the place of the one that waits.</summary>
    /// <exception cref="ArgumentException">The picture is of another size.</exception>
    public void Put(BridgeState state, PixelBuffer picture)
    {
        if (picture.Size != size)
        {
            throw new ArgumentException("The picture is not of the bridge's size.", nameof(picture));
        }

        lock (_gate)
        {
            Buffer.BlockCopy(picture.Bytes, 0, _waiting.Bytes, 0, picture.Bytes.Length);
            _state = state;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Waits for a frame and takes it; the picture stays the taker's until it takes the next.</summary>
    /// <returns>False when the box is closed or nothing came within the time.</returns>
    public bool TryTake(TimeSpan patience, [NotNullWhen(true)] out BridgeState? state, out PixelBuffer picture)
    {
        lock (_gate)
        {
            if (_state is null && !_closed)
            {
                Monitor.Wait(_gate, patience);
            }

            state = _closed ? null : _state;
            if (state is not null)
            {
                (_waiting, _taken) = (_taken, _waiting);
                _state = null;
            }

            picture = _taken;
            return state is not null;
        }
    }

    /// <summary>Wakes whoever waits, for good.</summary>
    public void Close()
    {
        lock (_gate)
        {
            _closed = true;
            Monitor.PulseAll(_gate);
        }
    }
}
