using System.CommandLine;
using System.IO;
using Harvester.Cli.Arguments;
using Harvester.Cli.Plans;

namespace Harvester.Cli.Commands.Plans;

/// <summary>The options that say in which simulated world a plan runs.</summary>
internal sealed class PlanWorldOptions
{
    private readonly Option<FileInfo?> _roads = new("--roads")
    {
        Description = "Road network to drive on, a file or folder [default: a town generated from the plan's seed]",
        HelpName = "FILE",
    };

    private readonly Option<string> _detail = DetailOption.Create();

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Options.Add(_roads);
        command.Options.Add(_detail);
    }

    /// <summary>The world that the command line describes.</summary>
    public PlanWorld Parse(ParseResult parsed) =>
        new(parsed.GetValue(_roads)?.FullName, DetailOption.Parse(parsed.GetRequiredValue(_detail)));
}
