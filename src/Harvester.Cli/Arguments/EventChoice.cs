using System.CommandLine;
using Harvester.Sessions.Events;

namespace Harvester.Cli.Arguments;

/// <summary>The options about events.</summary>
internal sealed class EventChoice
{
    private Option<bool> Events { get; } =
        new("--events") { Description = "Find near misses, hard braking and collisions at every tick, and list them in events.jsonl" };

    public void AddTo(Command command) => command.Add(Events);

    /// <summary>The options; null if no events are to be found.</summary>
    public EventOptions? Parse(ParseResult parsed) => parsed.GetValue(Events) ? new EventOptions() : null;
}
