using Harvester.Runs.Faults;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Harvesting;

/// <summary>Makes the changes of a harvest when their time has come.</summary>
/// <param name="changes">The changes.</param>
internal sealed class ChangeSchedule(IReadOnlyList<TimedChange> changes)
{
    private readonly List<TimedChange> _left = [.. changes];

    /// <summary>Makes the changes that are due, before a tick.</summary>
    /// <param name="game">The game.</param>
    /// <param name="taken">Number of frames taken.</param>
    /// <exception cref="UsageException">A change cannot be made.</exception>
    public void Apply(SimulatedGame game, int taken)
    {
        for (int i = 0; i < _left.Count; i++)
        {
            TimedChange change = _left[i];
            if (taken > change.Frame || game.Shown.TimeSeconds >= change.Seconds || game.Shown.GameFrame >= change.GameFrame)
            {
                _left.RemoveAt(i--);
                try
                {
                    game.Make(change.Change);
                }
                catch (ArgumentException e)
                {
                    throw new UsageException($"--change \"{change.Text}\": {e.Message.Split(" (Parameter")[0]}");
                }
            }
        }
    }
}
