using System.Diagnostics.CodeAnalysis;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The newest frame until the bridge's thread takes it for the client. Two images are swapped, so that none is allocated per frame. If a
/// requested frame is replaced by a newer one, the newer one counts as requested.
/// </summary>
/// <remarks>
/// A client that answers is sent a frame when it has answered the last one or has asked for one: a sent frame waits in the buffers of two
/// machines and cannot be taken back, so a frame sent before the last is answered would be old when it is read.
/// </remarks>
/// <typeparam name="TClient">Clients, compared by reference.</typeparam>
/// <param name="size">Size of the images, pixels.</param>
/// <param name="inbox">Knows the current client.</param>
/// <param name="needsAnswers">Whether a frame waits until the client has answered the last one.</param>
internal sealed class FrameOutbox<TClient>(ImageSize size, ClientInbox<TClient> inbox, bool needsAnswers) : IFrameOutbox
    where TClient : class
{
    private readonly object _gate = new();
    private PixelBuffer _waiting = new(size);
    private PixelBuffer _taken = new(size);
    private BridgeState? _state;
    private long _lastSent;
    private bool _isAnswered = true;
    private bool _closed;

    /// <inheritdoc/>
    public bool IsFrameAwaited
    {
        get
        {
            lock (_gate)
            {
                return _state is null && (!needsAnswers || (_isAnswered && inbox.Client is not null));
            }
        }
    }

    /// <inheritdoc/>
    /// <exception cref="ArgumentException">The image has another size.</exception>
    public bool Publish(BridgeState state, PixelBuffer picture)
    {
        if (picture.Size != size)
        {
            throw new ArgumentException("The picture is not of the bridge's size.", nameof(picture));
        }

        lock (_gate)
        {
            if (inbox.HasClientGone)
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

    /// <summary>
    /// Waits for a frame that may be sent, and takes it. The caller may use the image until it takes the next. One that may not be sent
    /// waits until a newer one replaces it; without a client, all may.
    /// </summary>
    /// <param name="patience">Maximum time to wait.</param>
    /// <param name="state">The frame's state; null if there is no frame.</param>
    /// <param name="picture">The frame's image.</param>
    /// <param name="client">The client to send it to; null if there is none.</param>
    /// <returns>
    /// False if the outbox is closed, no frame could be taken within the time, or an answer that changed nothing ended the wait.
    /// </returns>
    public bool TryTake(TimeSpan patience, [NotNullWhen(true)] out BridgeState? state, out PixelBuffer picture, out TClient? client)
    {
        lock (_gate)
        {
            if (!MaySend(out client) && !_closed)
            {
                Monitor.Wait(_gate, patience);
            }

            state = MaySend(out client) ? _state : null;
            if (state is not null)
            {
                // A requested frame needs no answer: the client wants it, and while the game is paused it may show what the client has
                // seen and answered already.
                if (client is not null && !state.IsAskedFor)
                {
                    (_lastSent, _isAnswered) = (state.Frame, false);
                }

                (_waiting, _taken) = (_taken, _waiting);
                _state = null;
            }

            picture = _taken;
            return state is not null;
        }
    }

    /// <summary>
    /// Takes note of a message of the current client. It answers the frame that it names and all before it, or every frame sent if it
    /// names none. A step, a request and a restart answer nothing: they lead to the frame that they ask for, and an answer would add one
    /// that the client does not wait for.
    /// </summary>
    public void Answer(TClient sender, ClientMessage message)
    {
        if (message is StepMessage or RequestFrameMessage or RestartMessage)
        {
            return;
        }

        long? named = message switch
        {
            ControlsMessage controls => controls.Frame,
            IndicatorsMessage indicators => indicators.Frame,
            _ => null,
        };
        lock (_gate)
        {
            _isAnswered |= inbox.Client == sender && (named is null || named >= _lastSent);
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Drops the waiting frame and applies a change of client in one step. The new client is owed nothing.</summary>
    public void Clear(Action change)
    {
        lock (_gate)
        {
            change();
            _state = null;
            (_lastSent, _isAnswered) = (0, true);
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

    private bool MaySend(out TClient? client)
    {
        client = inbox.Client;
        return !_closed && _state is { } state && (!needsAnswers || client is null || _isAnswered || state.IsAskedFor);
    }
}
