using System.CommandLine;
using Harvester.Geometry.Grids;
using Harvester.Runs.Faults;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Arguments;

/// <summary>The size of bird's-eye maps.</summary>
internal sealed class BirdsEyeOptions
{
    private Option<double?> Size { get; } =
        new("--birds-eye-size") { Description = "Side of bird's-eye maps, metres [default: 80]", HelpName = "M" };

    private Option<double?> Cell { get; } =
        new("--birds-eye-cell") { Description = "Side of their cells, metres [default: 0.2]", HelpName = "M" };

    public void AddTo(Command command)
    {
        command.Options.Add(Size);
        command.Options.Add(Cell);
    }

    /// <summary>The size.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="isOn">Whether the harvest has bird's-eye maps.</param>
    /// <exception cref="UsageException">There is no such grid, or there are no maps.</exception>
    public GridShape Parse(ParseResult parsed, bool isOn)
    {
        (double? size, double? cell) = (parsed.GetValue(Size), parsed.GetValue(Cell));
        if (!isOn && (size ?? cell) is not null)
        {
            throw new UsageException($"{(size is null ? Cell.Name : Size.Name)} needs {FrameChannels.BirdsEye.Switch.Option}.");
        }

        var shape = new GridShape(size ?? GridShape.Usual.SideMetres, cell ?? GridShape.Usual.CellMetres);
        return shape.Problem is { } problem ? throw new UsageException($"{Size.Name} and {Cell.Name}: {problem}") : shape;
    }
}
