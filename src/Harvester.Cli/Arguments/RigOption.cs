using System.CommandLine;
using System.CommandLine.Parsing;
using Harvester.Capture.Labelling;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Arguments;

/// <summary>--rig: several cameras and LiDARs instead of the single camera.</summary>
internal sealed class RigOption
{
    private static readonly string[] OfSingleCamera =
    [
        "--size",
        "--fov",
        "--focal-scale",
        "--centre-offset",
        "--k1",
        "--k2",
        "--calibration",
    ];

    private readonly Option<FileInfo?> _file = new("--rig")
    {
        Description = "Cameras and LiDARs from this file (docs/rigs.md); --frames and --hz then count moments",
        HelpName = "FILE",
    };

    /// <summary>Adds the option to a command.</summary>
    public void AddTo(Command command) => command.Options.Add(_file);

    /// <summary>The plan with the rig of the command line, if it has one: each moment then has a frame for each camera.</summary>
    /// <exception cref="UsageException">An option contradicts the rig, or the rig takes too long.</exception>
    /// <exception cref="DatasetFormatException">The file is not a rig.</exception>
    public HarvestPlan AppliedTo(ParseResult parsed, HarvestPlan plan)
    {
        if (parsed.GetValue(_file) is not { } file)
        {
            return plan;
        }

        if (OfSingleCamera.FirstOrDefault(name => parsed.GetResult(name) is OptionResult { Implicit: false }) is { } contradicted)
        {
            throw new UsageException(
                $"{contradicted} cannot be used with --rig, which gives each camera its size, field of view and lens."
            );
        }

        if (plan.Options.MaskMethod != MaskMethod.Rays)
        {
            throw new UsageException("With --rig, masks come from rays. Use --masks without a value.");
        }

        if (plan.Options.Pairs.IsAny)
        {
            throw new UsageException("The --pair options cannot be used with --rig.");
        }

        return RigMounting.Planned(plan, RigFile.Read(file.FullName, plan.Options.Masks, plan.Options.Depth));
    }
}
