using System.CommandLine;
using System.CommandLine.Parsing;
using Harvester.Capture.Labelling;
using Harvester.Cli.Harvesting;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Rigs;

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

        return Mounted(plan, Read(file.FullName, plan.Options.Masks, plan.Options.Depth));
    }

    /// <summary>The plan with a rig: each moment then has a frame for each camera.</summary>
    public static HarvestPlan Mounted(HarvestPlan plan, Rig rig)
    {
        int views = rig.Cameras.Count;
        int frames = checked(plan.Frames * views);
        return plan with
        {
            Frames = frames,
            FovDegrees = rig.Cameras[0].VerticalFovDegrees,
            Options = plan.Options with
            {
                Rig = rig,
                Image = rig.Cameras[0].Image,
                Lens = rig.Cameras[0].Lens,
                MaxFrames = frames,
                Places = plan.Options.Places! with { ViewsPerMoment = views },
                QueueCapacity = Math.Max(plan.Options.QueueCapacity, 2 * views),
            },
        };
    }

    /// <summary>Reads the file of a rig.</summary>
    /// <param name="path">The file.</param>
    /// <param name="masks">Whether its views have masks.</param>
    /// <param name="depth">Whether its views have depth maps.</param>
    /// <exception cref="UsageException">The rig takes too long.</exception>
    /// <exception cref="DatasetFormatException">The file is not a rig.</exception>
    public static Rig Read(string path, bool masks, bool depth)
    {
        Rig rig;
        try
        {
            rig = RigParser.Parse(InputFile.ReadAllText(path));
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"'{path}' is not a rig: {e.Message.TrimEnd('.')}.", e);
        }

        return RigBudget.ProblemOf(rig, RigBudget.SecondsPerMoment(rig, masks, depth)) is { } problem
            ? throw new UsageException(problem)
            : rig;
    }
}
