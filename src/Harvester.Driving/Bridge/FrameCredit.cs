namespace Harvester.Driving.Bridge;

/// <summary>
/// Decides when a client may be sent a frame: when it has answered the last one or has asked for one. A sent frame waits in the buffers of
/// two machines and cannot be taken back, so a frame sent before the last is answered would be old when it is read.
/// </summary>
internal sealed class FrameCredit
{
    private readonly object _gate = new();
    private long _lastSent;
    private bool _isAnswered = true;

    /// <summary>Whether the client has answered the last frame.</summary>
    public bool IsAnswered
    {
        get
        {
            lock (_gate)
            {
                return _isAnswered;
            }
        }
    }

    /// <summary>
    /// Spends the credit for a frame, if it may be sent. A requested frame needs no answer: the client wants it, and while the game is
    /// paused it may show what the client has seen and answered already.
    /// </summary>
    public bool TrySpend(BridgeState state)
    {
        if (state.IsAskedFor)
        {
            return true;
        }

        lock (_gate)
        {
            if (!_isAnswered)
            {
                return false;
            }

            _lastSent = state.Frame;
            _isAnswered = false;
            return true;
        }
    }

    /// <summary>
    /// Takes note of a message. It answers the frame that it names and all before it, or every frame sent if it names none. A step, a
    /// request and a restart answer nothing: they lead to the frame that they ask for, and an answer would add one that the client does not
    /// wait for.
    /// </summary>
    public void Receive(ClientMessage word)
    {
        if (word is StepMessage or RequestFrameMessage or RestartMessage)
        {
            return;
        }

        long? named = word switch
        {
            ControlsMessage controls => controls.Frame,
            IndicatorsMessage indicators => indicators.Frame,
            _ => null,
        };
        lock (_gate)
        {
            _isAnswered |= named is null || named >= _lastSent;
        }
    }
}
