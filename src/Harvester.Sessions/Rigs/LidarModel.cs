namespace Harvester.Sessions.Rigs;

/// <summary>A LiDAR that a rig can name instead of its beams.</summary>
/// <param name="Name">Its name.</param>
/// <param name="BeamsDegrees">Elevation of its beams, degrees, from the top.</param>
/// <param name="FiringSeconds">Time between two firings, seconds.</param>
/// <param name="RateHz">Usual turns per second.</param>
/// <param name="RangeMetres">Range, metres.</param>
public sealed record LidarModel(string Name, IReadOnlyList<double> BeamsDegrees, double FiringSeconds, double RateHz, double RangeMetres)
{
    /// <summary>
    /// The predefined models. HDL-32E and VLP-16 are as in their manuals. The angles of an HDL-64E are calibrated for each unit; here the
    /// upper 32 beams are a third of a degree apart and the lower 32 half a degree, as its data sheet says.
    /// </summary>
    public static IReadOnlyList<LidarModel> All { get; } =
    [
        new(
            "HDL-32E",
            [
                10.67,
                9.33,
                8,
                6.67,
                5.33,
                4,
                2.67,
                1.33,
                0,
                -1.33,
                -2.67,
                -4,
                -5.33,
                -6.67,
                -8,
                -9.33,
                -10.67,
                -12,
                -13.33,
                -14.67,
                -16,
                -17.33,
                -18.67,
                -20,
                -21.33,
                -22.67,
                -24,
                -25.33,
                -26.67,
                -28,
                -29.33,
                -30.67,
            ],
            46.08e-6,
            20,
            100
        ),
        new(
            "HDL-64E",
            [
                .. Enumerable.Range(0, 32).Select(static beam => Math.Round(2 - (beam / 3.0), 2)),
                .. Enumerable.Range(0, 32).Select(static beam => -8.83 - (beam / 2.0)),
            ],
            48e-6,
            10,
            120
        ),
        new("VLP-16", [.. Enumerable.Range(0, 16).Select(static beam => 15.0 - (2 * beam))], 55.296e-6, 10, 100),
    ];

    /// <summary>The model of a name; null if there is none.</summary>
    public static LidarModel? Find(string name) => All.FirstOrDefault(model => model.Name == name);

    /// <summary>Number of firings in one turn.</summary>
    /// <param name="rateHz">Turns per second; greater than 0.</param>
    public int ColumnsAt(double rateHz) => (int)Math.Round(1 / (rateHz * FiringSeconds));
}
