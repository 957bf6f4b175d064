using System.CommandLine;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Faults;
using Harvester.Runs.Relabelling;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Arguments;

/// <summary>The options of a lens. Several commands share them.</summary>
internal sealed class LensOptions
{
    private const string CoefficientForm = "a number from -1 to 1";

    private readonly Option<double> _focalScale = ValueParsers.Number(
        "--focal-scale",
        "N",
        "Factor on the focal length",
        value => value is > 0 and <= 100,
        "a number greater than 0 and at most 100"
    );

    private readonly Option<Vector2D?> _centre = ValueParsers.Optional<Vector2D>(
        "--centre-offset",
        "X,Y",
        "Shift of the principal point right and down, as fractions of width and height [default: 0,0]",
        text => NumberText.ReadList(text, 2) is [>= -1 and <= 1, >= -1 and <= 1] n ? new Vector2D(n[0], n[1]) : null,
        "two numbers from -1 to 1, e.g. 0.01,-0.005"
    );

    private readonly Option<double> _k1 = Coefficient("--k1", "Radial distortion, coefficient of r^2");
    private readonly Option<double> _k2 = Coefficient("--k2", "Radial distortion, coefficient of r^4");
    private readonly Option<FileInfo?> _file = new("--calibration")
    {
        Description = "Lens from a file with the output of harvester calibrate, or from the mod's ini file",
        HelpName = "FILE",
    };

    public LensOptions()
    {
        _focalScale.DefaultValueFactory = _ => 1;
    }

    /// <summary>Adds the numeric options of a lens to a command.</summary>
    public void AddNumbersTo(Command command)
    {
        foreach (Option option in Numbers)
        {
            command.Options.Add(option);
        }
    }

    /// <summary>Adds all options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Options.Add(_file);
        AddNumbersTo(command);
    }

    /// <summary>The lens that a command line describes; by default the ideal lens.</summary>
    /// <exception cref="UsageException">Both a file and numbers are given.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">The file does not describe a lens.</exception>
    public Lens Parse(ParseResult parsed)
    {
        FileInfo? file = parsed.CommandResult.Command.Options.Contains(_file) ? parsed.GetValue(_file) : null;
        if (file is null)
        {
            Vector2D shift = parsed.GetValue(_centre) ?? default;
            return new Lens(parsed.GetValue(_focalScale), shift.X, shift.Y, parsed.GetValue(_k1), parsed.GetValue(_k2));
        }

        return Numbers.FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false }) is { } number
            ? throw new UsageException($"{_file.Name} and {number.Name} both describe the lens. Give one of them.")
            : LensFile.Read(file.FullName);
    }

    private Option[] Numbers => [_focalScale, _centre, _k1, _k2];

    private static Option<double> Coefficient(string name, string description)
    {
        Option<double> option = ValueParsers.Number(name, "N", description, value => value is >= -1 and <= 1, CoefficientForm);
        option.DefaultValueFactory = _ => 0;
        return option;
    }
}
