using System.Globalization;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Tests.Evaluation.Figures;

/// <summary>Departures in drives written out by hand; the tests of the Python package read the same file.</summary>
public sealed class LaneKeepingVectorTests
{
    private const int ManyLanes = 9;

    private static readonly string[][] Rows =
    [
        .. File.ReadAllLines(Path.Combine(AppContext.BaseDirectory, "Evaluation", "Figures", "lane-keeping.csv"))
            .Skip(1)
            .Select(line => line.Split(',')),
    ];

    public static TheoryData<string> DriveNames => [.. Rows.Select(row => row[0]).Distinct()];

    [Theory]
    [MemberData(nameof(DriveNames))]
    public void Departures_begin_where_the_file_says(string drive)
    {
        string[][] rows = [.. Rows.Where(row => row[0] == drive)];

        int[] found = [.. new LaneKeeping([.. rows.Select(SampleOf)]).Departures];

        Assert.Equal(rows.Index().Where(row => row.Item[7] == "1").Select(row => row.Index), found);
    }

    private static DriveSample SampleOf(string[] row, int index) =>
        Drives.At(index) with
        {
            Lane = PlacementOf(row),
            IsByController = row[5] == "1",
            IsTeleported = row[6] == "1",
        };

    /// <summary>A place in the lane from which the car reaches as far as the row says; null in a junction.</summary>
    private static LanePlacement? PlacementOf(string[] row)
    {
        (bool isBeyond, bool isAcross) = (row[3] == "1", row[4] == "1");
        return row[1].Length == 0
            ? isBeyond
                ? new LanePlacement(-1, null, 0, 0, 0, 1)
                : null
            : new LanePlacement(
                int.Parse(row[1], CultureInfo.InvariantCulture),
                row[2].Length == 0 ? null : int.Parse(row[2], CultureInfo.InvariantCulture),
                isBeyond ? int.Parse("0" + row[2], CultureInfo.InvariantCulture) + 1 : ManyLanes,
                5.4,
                isAcross ? 2 : 0,
                1
            );
    }
}
