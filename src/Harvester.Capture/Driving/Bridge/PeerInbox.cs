using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace Harvester.Capture.Driving.Bridge;

/// <summary>Messages of a peer until the game takes them: commands in their order, of controls and indicators only the newest.</summary>
internal sealed class PeerInbox
{
    /// <summary>A peer that sends commands faster than the game takes them loses the newest.</summary>
    private const int CommandCapacity = 256;

    private readonly object _gate = new();
    private readonly Queue<PeerMessage> _commands = new();
    private PeerMessage? _newest;

    /// <summary>Puts a message in.</summary>
    /// <returns>Whether there was room.</returns>
    public bool TryPut(PeerMessage message)
    {
        lock (_gate)
        {
            if (message is ControlsMessage or IndicatorsMessage)
            {
                _newest = message;
                return true;
            }

            if (_commands.Count >= CommandCapacity)
            {
                return false;
            }

            _commands.Enqueue(message);
            return true;
        }
    }

    /// <summary>Takes a message out, commands first.</summary>
    public bool TryTake([NotNullWhen(true)] out PeerMessage? message)
    {
        lock (_gate)
        {
            message = _commands.Count > 0 ? _commands.Dequeue() : _newest;
            if (ReferenceEquals(message, _newest))
            {
                _newest = null;
            }

            return message is not null;
        }
    }
}
