using System.Collections;

namespace Harvester.Sessions.Reading;

/// <summary>The problems of a session or a dataset, up to a number beyond which nobody reads them.</summary>
internal sealed class ProblemList : IReadOnlyList<SessionProblem>
{
    /// <summary>Problems that are kept.</summary>
    public const int MaxProblems = 10_000;

    private readonly List<SessionProblem> _problems = [];

    /// <inheritdoc/>
    public int Count => _problems.Count;

    /// <summary>Whether there were more than are kept; the last one of the list says so.</summary>
    public bool IsFull => _problems.Count > MaxProblems;

    /// <inheritdoc/>
    public SessionProblem this[int index] => _problems[index];

    /// <summary>Adds a problem, if there is room.</summary>
    public void Add(SessionProblem problem)
    {
        if (IsFull)
        {
            return;
        }

        _problems.Add(
            _problems.Count < MaxProblems
                ? problem
                : problem with
                {
                    Message = $"more than {MaxProblems} problems; this and later ones are not listed.",
                }
        );
    }

    /// <summary>Adds problems as long as there is room.</summary>
    public void AddRange(IEnumerable<SessionProblem> problems)
    {
        foreach (SessionProblem problem in problems)
        {
            Add(problem);
            if (IsFull)
            {
                return;
            }
        }
    }

    /// <inheritdoc/>
    public IEnumerator<SessionProblem> GetEnumerator() => _problems.GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
