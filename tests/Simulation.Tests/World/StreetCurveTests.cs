using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.World;

public class StreetCurveTests
{
    private const double Radius = 60;

    [Fact]
    public void Curve_through_nodes_of_a_circle_stays_on_it()
    {
        StreetCurve curve = QuarterCircle();
        for (double distance = 15; distance < curve.Length - 15; distance += 1.7)
        {
            Vector3D place = curve.PositionAt(distance);

            // Nodes 9.4 m apart: the cubic leaves the circle by about 1e-3 of the sagitta of 0.18 m between them.
            Assert.Equal(Radius, Math.Sqrt((place.X * place.X) + (place.Y * place.Y)), 2);
            Assert.InRange(curve.CurvatureAt(distance), 0.9 / Radius, 1.1 / Radius);
        }
    }

    [Fact]
    public void Project_finds_the_station_a_point_was_offset_from()
    {
        StreetCurve curve = QuarterCircle();
        for (double distance = 2; distance < curve.Length - 2; distance += 3.3)
        {
            foreach (double offset in new[] { -12.0, -2.7, 0, 2.7, 12 })
            {
                Vector3D point = curve.OffsetAt(distance, offset);
                Assert.Equal(distance, curve.Project(point, distance + 1.5), 6);
            }
        }
    }

    /// <summary>Turns left from east to north about the origin.</summary>
    private static StreetCurve QuarterCircle() =>
        new([
            .. Enumerable
                .Range(0, 11)
                .Select(i =>
                {
                    (double sin, double cos) = Math.SinCos(Math.PI / 2 * i / 10);
                    return new Vector3D(Radius * cos, Radius * sin, 0);
                }),
        ]);
}
