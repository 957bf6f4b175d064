using System.CommandLine;
using Harvester.Driving.Controllers;
using Harvester.Runs.Faults;

namespace Harvester.Cli.Arguments;

/// <summary>--controller and --emergency-brake.</summary>
internal sealed class ControllerOptions
{
    private readonly Option<string> _controller;
    private readonly Option<bool> _emergencyBrake = new("--emergency-brake")
    {
        Description = "Brake as hard as necessary behind vehicles, which DeepDriving's control law does not",
    };

    /// <summary>Creates the options.</summary>
    /// <param name="purpose">Description of --controller.</param>
    /// <param name="defaultName">Name of the default controller.</param>
    public ControllerOptions(string purpose, string defaultName)
    {
        _controller = new Option<string>("--controller")
        {
            Description = $"{purpose}: stanley or deepdriving",
            HelpName = "NAME",
            DefaultValueFactory = _ => defaultName,
        };
    }

    public IEnumerable<Option> All => [_controller, _emergencyBrake];

    /// <summary>The plan that the options describe.</summary>
    /// <exception cref="UsageException">There is no controller of that name.</exception>
    public ControllerPlan Parse(ParseResult parsed) =>
        new()
        {
            Kind = parsed.GetRequiredValue(_controller) switch
            {
                "stanley" => ControllerKind.Stanley,
                "deepdriving" => ControllerKind.DeepDriving,
                string other => throw new UsageException($"--controller takes stanley or deepdriving, not '{other}'."),
            },
            BrakesInEmergency = parsed.GetValue(_emergencyBrake),
        };
}
