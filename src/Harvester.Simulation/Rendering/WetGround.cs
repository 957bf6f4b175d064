using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Mirrors the picture in wet asphalt. The ground is taken as level and the camera as upright: what lies above the foot of an object by so
/// many rows is then seen in the ground by as many rows below it.
/// </summary>
internal sealed class WetGround(View view, ScreenTriangles triangles, int[] ids, float[] nearness)
{
    /// <summary>Steeper ground does not hold water: the cosine of 18 degrees.</summary>
    private const float MinLevel = 0.95f;

    /// <summary>Squares of this many pixels share a reflection, and rows are searched in steps as large.</summary>
    private const int Block = 2;
    private const int SearchStep = 3;

    /// <summary>The fraction of light that still water reflects straight on.</summary>
    private const double Straight = 0.02;

    /// <summary>How much of it wet asphalt reflects between puddles, which are as large as the noise per metre makes them.</summary>
    private const double BetweenPuddles = 0.35;
    private const double PuddlesPerMetre = 0.22;
    private const float PuddleFrom = 0.5f;
    private const float PuddleEdge = 6;

    private readonly double _horizon =
        view.Camera.CentreY
        + (
            view.Camera.FocalY
            * view.Camera.Pose.Axes.Forward.Z
            / Math.Sqrt(Math.Max(1e-6, 1 - (view.Camera.Pose.Axes.Forward.Z * view.Camera.Pose.Axes.Forward.Z)))
        );
    private readonly NoisePlane _puddles = new(view.Camera.Pose.Position.X, view.Camera.Pose.Position.Y, PuddlesPerMetre);

    /// <summary>Adds reflections to a picture.</summary>
    /// <param name="wetness">From 0, dry, to 1.</param>
    /// <param name="target">The picture, in which depths and handles stay as they are.</param>
    /// <param name="before">Receives the colours without reflections.</param>
    public void Reflect(double wetness, RenderTarget target, byte[] before)
    {
        Array.Copy(target.Colour, before, before.Length);
        Parallel.For(
            0,
            (target.Height + Block - 1) / Block,
            block =>
            {
                // Ground at the horizon and above it is not level.
                int top = block * Block;
                for (int column = 0; top + 0.5 > _horizon && column < target.Width; column += Block)
                {
                    ReflectBlock(wetness, target, before, column, top);
                }
            }
        );
    }

    private void ReflectBlock(double wetness, RenderTarget target, byte[] before, int column, int top)
    {
        int first = (top * target.Width) + column;
        if (!IsWet(first))
        {
            return;
        }

        double depth = view.NearClip / nearness[first];
        double below = (top + 0.5 - _horizon) * depth;

        // The ray goes down by below while it goes forward by depth · focal length: the cosine of its angle with the vertical.
        double cosine = below / Math.Sqrt((below * below) + (depth * view.Camera.FocalY * depth * view.Camera.FocalY));

        // Schlick's approximation of Fresnel's reflection, F0 + (1 - F0) (1 - cos)⁵, times how wet the place is.
        double share =
            wetness
            * (Straight + ((1 - Straight) * Math.Pow(1 - Math.Clamp(cosine, 0, 1), 5)))
            * (BetweenPuddles + ((1 - BetweenPuddles) * PuddleAt(column, top, depth)));
        int source = (MirroredRow(column, top, below, target.Width) * target.Width) + column;
        for (int row = top; row < Math.Min(top + Block, target.Height); row++)
        {
            for (int pixel = (row * target.Width) + column; pixel < (row * target.Width) + Math.Min(column + Block, target.Width); pixel++)
            {
                for (int channel = 0; channel < 3 && IsWet(pixel); channel++)
                {
                    double own = before[(pixel * 3) + channel];
                    target.Colour[(pixel * 3) + channel] = (byte)(own + ((before[(source * 3) + channel] - own) * share) + 0.5);
                }
            }
        }
    }

    /// <summary>
    /// The row that is seen in the ground at a pixel: the first one upward that lies as high above its foot as the pixel lies below it.
    /// Objects nearer than that ground, whose foot is below the pixel, are skipped.
    /// </summary>
    /// <param name="column">The pixel's column.</param>
    /// <param name="row">The pixel's row.</param>
    /// <param name="below">Metres that the ground lies below the eye, times the focal length.</param>
    /// <param name="width">Width of the picture.</param>
    private int MirroredRow(int column, int row, double below, int width)
    {
        for (int other = row - SearchStep; other > 0; other -= SearchStep)
        {
            // Level ground at the other pixel's depth is seen at horizon + below / depth; its mirror image lies as far below the foot as
            // the object above it: row = 2 · foot - other.
            double foot = _horizon + (below * nearness[(other * width) + column] / view.NearClip);
            if (foot <= row + 1 && other <= (2 * foot) - row)
            {
                return other;
            }
        }

        return 0;
    }

    private bool IsWet(int pixel)
    {
        if (ids[pixel] == ScreenTriangles.Nothing)
        {
            return false;
        }

        ref readonly ScreenTriangle triangle = ref triangles[ids[pixel]];
        return triangle.Surface == Surface.Asphalt && triangle.Normal.Z > MinLevel;
    }

    private double PuddleAt(int column, int row, double depth)
    {
        Vector2D place = view.SampleAt(column, row);
        Axes axes = view.Camera.Pose.Axes;
        Vector3D away =
            (
                axes.Forward
                + (axes.Right * ((place.X - view.Camera.CentreX) / view.Camera.FocalX))
                - (axes.Up * ((place.Y - view.Camera.CentreY) / view.Camera.FocalY))
            ) * depth;
        Vector256<float> noise = _puddles.At(Vector256.Create((float)away.X), Vector256.Create((float)away.Y));
        return Math.Clamp((noise[0] - PuddleFrom) * PuddleEdge, 0, 1);
    }
}
