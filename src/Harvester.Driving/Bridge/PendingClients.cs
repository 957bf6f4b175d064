using System.Collections.Generic;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Who has yet to show the token: so many at most. Each leaves once, so only one of those who let it out (it has shown the token, its time is
/// over, another has come for its place) finds it here. When the room is full the one that has waited longest makes room: it is least likely to
/// be about to show the token.
/// </summary>
/// <param name="places">How many may wait; at least 1.</param>
internal sealed class PendingClients<T>(int places)
    where T : class
{
    private readonly object _gate = new();
    private readonly List<T> _waiting = [];
    private bool _isClosed;

    /// <summary>How many wait.</summary>
    public int Count
    {
        get
        {
            lock (_gate)
            {
                return _waiting.Count;
            }
        }
    }

    /// <summary>Lets one in.</summary>
    /// <returns>Who has to go: the one that has waited longest, or the newcomer when the room is closed; null for nobody.</returns>
    public T? Enter(T newcomer)
    {
        lock (_gate)
        {
            if (_isClosed)
            {
                return newcomer;
            }

            _waiting.Add(newcomer);
            if (_waiting.Count <= places)
            {
                return null;
            }

            T longest = _waiting[0];
            _waiting.RemoveAt(0);
            return longest;
        }
    }

    /// <summary>Lets one out.</summary>
    /// <returns>Whether it was still here.</returns>
    public bool TryLeave(T one)
    {
        lock (_gate)
        {
            return _waiting.Remove(one);
        }
    }

    /// <summary>Lets nobody in any more.</summary>
    /// <returns>Who waited.</returns>
    public IReadOnlyList<T> Close()
    {
        lock (_gate)
        {
            _isClosed = true;
            T[] left = [.. _waiting];
            _waiting.Clear();
            return left;
        }
    }
}
