using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Runs.Plans;
using Harvester.Simulation.Rendering;

namespace Harvester.Cli.Commands.Plans;

/// <summary>The options that say in which simulated world a plan runs.</summary>
internal sealed class PlanWorldOptions
{
    private readonly Option<string> _detail = DetailOption.Create();

    /// <summary>The road network.</summary>
    public Option<FileInfo?> Roads { get; } =
        new("--roads")
        {
            Description = "Road network to drive on, a file or folder [default: a town generated from the plan's seed]",
            HelpName = "FILE",
        };

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Options.Add(Roads);
        command.Options.Add(_detail);
    }

    /// <summary>The world that the command line describes.</summary>
    public PlanWorld Parse(ParseResult parsed) => WithRoads(parsed) with { Detail = DetailOption.Parse(parsed.GetRequiredValue(_detail)) };

    /// <summary>The world of a command that makes no pictures.</summary>
    public PlanWorld WithRoads(ParseResult parsed) => new(parsed.GetValue(Roads)?.FullName, Detail.Plain);
}
