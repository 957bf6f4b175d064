namespace Harvester.Driving.Bridge;

/// <summary>
/// Connections that have not sent a valid hello yet, up to a maximum. Each is removed exactly once: because it has sent one, its time is
/// over, or a newer connection replaces it. At the maximum, the connection that has waited longest is replaced: it is the least likely to
/// send one.
/// </summary>
/// <param name="places">Maximum number of pending connections; at least 1.</param>
internal sealed class PendingClients<T>(int places)
    where T : class
{
    private readonly object _gate = new();
    private readonly List<T> _waiting = [];
    private bool _isClosed;

    /// <summary>Number of pending connections.</summary>
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

    /// <summary>Adds a pending connection.</summary>
    /// <returns>
    /// The connection to close: the one that has waited longest, or the new one after <see cref="Close"/>; null if there is none.
    /// </returns>
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

    /// <summary>Removes a connection.</summary>
    /// <returns>Whether it was still pending.</returns>
    public bool TryLeave(T one)
    {
        lock (_gate)
        {
            return _waiting.Remove(one);
        }
    }

    /// <summary>Accepts no further connections.</summary>
    /// <returns>The connections that were pending.</returns>
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
