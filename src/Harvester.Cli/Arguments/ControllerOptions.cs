using System.Collections.Generic;
using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Driving.Controllers;

namespace Harvester.Cli.Arguments;

/// <summary>The options that say which controller drives.</summary>
internal sealed class ControllerOptions
{
    private readonly Option<string> _controller;
    private readonly Option<bool> _emergencyBrake = new("--emergency-brake")
    {
        Description = "Brake as hard as necessary behind vehicles, which DeepDriving's control law does not",
    };

    /// <summary>Makes the options.</summary>
    /// <param name="purpose">What the controller is for.</param>
    /// <param name="usual">Its name when none is given.</param>
    public ControllerOptions(string purpose, string usual)
    {
        _controller = new Option<string>("--controller")
        {
            Description = $"{purpose}: stanley or deepdriving",
            HelpName = "NAME",
            DefaultValueFactory = _ => usual
        };
    }

    public IEnumerable<Option> All => [_controller, _emergencyBrake];

    /// <summary>What they ask for.</summary>
    /// <exception cref="UsageException">Nobody has that name.</exception>
    public ControllerPlan Parse(ParseResult parsed) => new()
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
