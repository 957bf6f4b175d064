namespace Harvester.Driving.Bridge;

/// <summary>
/// Says when a client may be sent a frame: when it has answered the last one, or has asked for one. What has been sent waits in the buffers
/// of two machines and cannot be taken back, so a second frame behind one that is not answered would be old by the time it is read.
/// </summary>
internal sealed class FrameCredit
{
    private readonly object _gate = new();
    private long _lastSent;
    private bool _isAnswered = true;

    /// <summary>
    /// Takes it that a frame is sent now, where it may be. One that was asked for needs no answer: the client has said that it wants it,
    /// and a world that stands may show it what it has seen and answered already.
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
    /// Hears a word of the client's. It answers the frame that it names and those before, or all that were sent if it names none. A step
    /// and a request answer nothing: they bring the frame that they ask for, and another with it would be one more than the client waits
    /// for.
    /// </summary>
    public void Hear(ClientMessage word)
    {
        if (word is StepMessage or RequestFrameMessage)
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
