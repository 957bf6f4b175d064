using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Checks a calibration file: all matrices exist with their sizes, and P2 is a camera's.</summary>
internal sealed class KittiCalibrationCheck
{
    private const string Projection = "P2";
    private const int ProjectionSize = 12;
    private const int RotationSize = 9;

    private readonly List<SessionProblem> _problems = [];
    private readonly string _name;

    /// <summary>Reads a calibration file.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="name">The file.</param>
    /// <param name="rectification">Name of the 3 x 3 matrix in the benchmark.</param>
    /// <param name="others">Names of the other 3 x 4 matrices.</param>
    public KittiCalibrationCheck(DatasetContent dataset, string name, string rectification, params string[] others)
    {
        _name = name;
        Dictionary<string, int> sizes = others
            .Concat(["P0:", "P1:", Projection + ":", "P3:"])
            .ToDictionary(matrix => matrix, _ => ProjectionSize);
        sizes.Add(rectification, RotationSize);
        foreach ((int number, string text) in dataset.Lines(name).Where(line => line.Text.Length > 0))
        {
            Read(number, text.Split(' '), sizes);
        }

        _problems.AddRange(sizes.Keys.Select(matrix => new SessionProblem(name, null, $"{matrix.TrimEnd(':')} is missing.")));
    }

    /// <summary>The problems of the file.</summary>
    public IReadOnlyList<SessionProblem> Problems => _problems;

    /// <summary>P2 by rows; null if it is missing or not a camera's.</summary>
    public double[]? P2 { get; private set; }

    private void Read(int number, string[] words, Dictionary<string, int> sizes)
    {
        string matrix = words[0].TrimEnd(':');
        if (!sizes.Remove(words[0], out int size))
        {
            _problems.Add(new SessionProblem(_name, number, $"'{words[0]}' is not a matrix of the format, or occurs twice."));
        }
        else if (Numbers.Parse(words.Skip(1)) is not { } values || values.Length != size)
        {
            _problems.Add(new SessionProblem(_name, number, $"{matrix} does not have {size} numbers."));
        }
        else if (matrix == Projection)
        {
            // fx 0 cx tx, 0 fy cy ty, 0 0 1 tz.
            if (
                values[0] > 0
                && values[5] > 0
                && values[1..2].Concat(values[4..5]).Concat(values[8..10]).All(value => value == 0)
                && values[10] == 1
            )
            {
                P2 = values;
            }
            else
            {
                _problems.Add(new SessionProblem(_name, number, $"{Projection} is not the projection of a camera."));
            }
        }
    }
}
