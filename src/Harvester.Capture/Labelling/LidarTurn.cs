using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Depth;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The returns of one turn of a LiDAR from part of its rays: a coarse grid of columns and beams, denser where neighbouring hits disagree;
/// the rest is interpolated. See docs/rigs.md.
/// </summary>
internal sealed class LidarTurn
{
    /// <summary>The first cells: columns and beams between their corners. Columns are many times as dense as beams.</summary>
    private const int FirstColumns = 24;
    private const int FirstBeams = 4;

    /// <summary>A step is made only with this many rays left, so that it never runs out of them.</summary>
    private const int SpareRays = 5;

    /// <summary>
    /// Planes that predict each other's hits this well need no ray between, metres. Between the hits the mean of the planes is wrong by
    /// a fraction of it.
    /// </summary>
    private const double ToleranceMetres = 0.08;

    private readonly RigLidar _lidar;
    private readonly LidarRays _rays;
    private readonly int[] _beams;
    private readonly DepthGrid _grid;
    private readonly DepthMapper _mapper;
    private readonly Dictionary<int, LidarReturn> _returns = [];

    /// <summary>Starts a turn; no ray is cast before the first <see cref="Step"/>.</summary>
    /// <param name="lidar">The LiDAR; at least two columns and two beams.</param>
    /// <param name="rays">Its rays.</param>
    public LidarTurn(RigLidar lidar, LidarRays rays)
    {
        (_lidar, _rays) = (lidar, rays);

        // Rows of the grid are beams by elevation, whatever their order in the sensor, so that neighbouring rows see neighbouring places.
        _beams = [.. Enumerable.Range(0, lidar.BeamsDegrees.Count).OrderBy(beam => lidar.BeamsDegrees[beam])];
        _grid = new DepthGrid(new ImageSize(lidar.Columns, _beams.Length), (column, row) => rays.LineOf(column, _beams[row]))
        {
            FirstWidth = FirstColumns,
            FirstHeight = FirstBeams,
            SamplesMiddles = false,
            LastSide = 1,
            ToleranceMetres = ToleranceMetres,
        };
        _mapper = new DepthMapper(_grid, Sample, Math.Max((int)(lidar.RayFraction * lidar.Rays), FirstRaysOf(lidar) + SpareRays));
    }

    /// <summary>Continues with a handful of rays.</summary>
    /// <returns>False if no ray is left to cast.</returns>
    public bool Step() => _mapper.Step();

    /// <summary>The returns by column and beam, those without a ray interpolated.</summary>
    public LidarReturn?[,] Complete()
    {
        DepthMap map = _mapper.Complete();
        var returns = new LidarReturn?[_lidar.Columns, _beams.Length];
        for (int at = 0; at < map.Metres.Length; at++)
        {
            (int column, int row) = (at % _lidar.Columns, at / _lidar.Columns);
            if (_returns.TryGetValue(at, out LidarReturn own))
            {
                returns[column, _beams[row]] = own;
            }
            else if (map.Metres[at] is > 0 and < double.PositiveInfinity && _returns.TryGetValue(map.Sources[at], out LidarReturn source))
            {
                // What was hit is that of the sample whose surface gives the depth; only the distance is new.
                returns[column, _beams[row]] = source with
                {
                    Hit = source.Hit with { Distance = map.Metres[at] },
                    IsInterpolated = true,
                };
            }
        }

        return returns;
    }

    /// <summary>The number of corners of the first cells.</summary>
    private static int FirstRaysOf(RigLidar lidar) =>
        CornersOf(lidar.Columns, FirstColumns) * CornersOf(lidar.BeamsDegrees.Count, FirstBeams);

    // Cells of a side over n places: ⌈(n - 1) / side⌉ = (n - 2) / side + 1 of them, with one corner more.
    private static int CornersOf(int places, int side) => ((places - 2) / side) + 2;

    private DepthSample Sample(int column, int row)
    {
        if (_rays.Cast(column, _beams[row]) is not { } met)
        {
            return new DepthSample(double.PositiveInfinity, default, RayHit.World, 0);
        }

        _returns[_grid.At(column, row)] = met;

        // All planes are in the frame of the sensor at the end of its turn, so that samples of moving sensors agree.
        Vector3D point = _grid.LineOf(column, row).At(met.Hit.Distance);
        return new DepthSample(met.Hit.Distance, SurfacePlane.Of(point, _rays.Sensor.Axes.ToLocal(met.Normal)), met.Hit.Entity, 0);
    }
}
