namespace Harvester.Geometry.Work;

/// <summary>
/// Advances a work and the works that its steps begin, innermost first. Disposing it, or an exception of a work, ends all works that have
/// begun, innermost first, so that each runs its finally blocks.
/// </summary>
/// <param name="work">The steps of the work; none is done before the first call of <see cref="Advance"/>.</param>
/// <param name="isTickOver">Called at each step after which the work may be interrupted; null to go on until a tick is needed.</param>
public sealed class WorkRun(IEnumerable<WorkStep> work, Func<bool>? isTickOver = null) : IDisposable
{
    private readonly Stack<(IEnumerator<WorkStep> Steps, int? Phase)> _begun = [];
    private IEnumerable<WorkStep>? _work = work ?? throw new ArgumentNullException(nameof(work));

    /// <summary>Number of the phase in which the last tick ended; null if no work named one.</summary>
    public int? Phase { get; private set; }

    /// <summary>Does a work at once.</summary>
    /// <param name="work">A work that needs no ticks.</param>
    /// <exception cref="InvalidOperationException">It needs a tick.</exception>
    public static void Complete(IEnumerable<WorkStep> work)
    {
        using var run = new WorkRun(work);
        if (run.Advance())
        {
            throw new InvalidOperationException("This work needs ticks of the game.");
        }
    }

    /// <summary>Does the work of one tick: all steps up to one that needs the next tick, or to a pause if the tick is over.</summary>
    /// <returns>Whether work is left; false from the end on.</returns>
    public bool Advance()
    {
        try
        {
            return AdvanceInTick();
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    /// <summary>Ends the work; nothing of it is done any more. Calling it again has no effect.</summary>
    public void Dispose()
    {
        _work = null;
        while (_begun.Count > 0)
        {
            try
            {
                _begun.Pop().Steps.Dispose();
            }
            catch
            {
                Dispose();
                throw;
            }
        }
    }

    private bool AdvanceInTick()
    {
        if (_work is { } first)
        {
            _work = null;
            _begun.Push((first.GetEnumerator(), null));
        }

        while (_begun.Count > 0)
        {
            (IEnumerator<WorkStep> steps, int? phase) = _begun.Peek();
            if (!steps.MoveNext())
            {
                _begun.Pop().Steps.Dispose();
                continue;
            }

            WorkStep step = steps.Current;
            if (step.Work is { } work)
            {
                _begun.Push((work.GetEnumerator(), step.Phase ?? phase));
            }
            else if (step.NeedsTick || isTickOver?.Invoke() == true)
            {
                Phase = step.Phase ?? phase;
                return true;
            }
        }

        return false;
    }
}
