using System.Numerics;
using Harvester.Geometry;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Quirks;

/// <summary>
/// What changes from picture to picture of a game that stands still: noise in every pixel, and textures that move on, such as foliage,
/// water and screens.
/// </summary>
/// <param name="seed">Seed of the noise.</param>
/// <param name="quirks">How much there is of it.</param>
internal sealed class PictureNoise(int seed, GameQuirks quirks)
{
    /// <summary>The texture moves in columns of space of this width, metres, of which one in <see cref="MovingOneIn"/> moves.</summary>
    private const double CellMetres = 3;
    private const uint MovingOneIn = 10;

    /// <summary>
    /// Waves of the moving texture: amplitude in grey levels, length in metres, and what passes from tick to tick, radians.
    /// </summary>
    private const double WaveLevels = 10;
    private const double WaveMetres = 0.5;
    private const double WaveStep = 0.7;

    /// <summary>The number of set bits of 64 random ones has this standard deviation, and is close to normally distributed.</summary>
    private const double BitDeviation = 4;
    private const int MeanBits = 32;

    /// <summary>Whether pictures of a still scene differ.</summary>
    public bool IsAny => quirks.PictureNoiseLevels > 0 || quirks.TexturesMove;

    /// <summary>Adds noise to a picture.</summary>
    /// <param name="picture">The picture without noise.</param>
    /// <param name="camera">Its camera.</param>
    /// <param name="tick">The tick that shows it.</param>
    /// <param name="target">Receives the picture with noise.</param>
    public void Apply(RenderTarget picture, RenderCamera camera, long tick, PixelBuffer target) =>
        Parallel.For(
            0,
            picture.Height,
            row =>
            {
                for (int column = 0; column < picture.Width; column++)
                {
                    int pixel = (row * picture.Width) + column;
                    double wave = quirks.TexturesMove ? WaveAt(picture, camera, tick, column, row) : 0;
                    for (int channel = 0; channel < 3; channel++)
                    {
                        long number = (((tick * 3) + channel) * picture.Depth.Length) + pixel;
                        ulong bits = Mixed(unchecked((ulong)number) ^ ((ulong)(uint)seed << 40));
                        double noise = (BitOperations.PopCount(bits) - MeanBits) / BitDeviation * quirks.PictureNoiseLevels;
                        double value = picture.Colour[(pixel * 3) + channel] + noise + wave;
                        target.Bytes[(pixel * 3) + channel] = (byte)Math.Clamp(Math.Round(value), 0, byte.MaxValue);
                    }
                }
            }
        );

    private static double WaveAt(RenderTarget picture, RenderCamera camera, long tick, int column, int row)
    {
        float depth = picture.Depth[(row * picture.Width) + column];
        if (float.IsPositiveInfinity(depth))
        {
            return 0;
        }

        Vector3D place = camera.Pose.ToWorld(
            new Vector3D(
                (column + 0.5 - camera.CentreX) / camera.FocalX * depth,
                depth,
                -(row + 0.5 - camera.CentreY) / camera.FocalY * depth
            )
        );
        long cell = unchecked(
            ((long)Math.Floor(place.X / CellMetres) * 73_856_093) ^ ((long)Math.Floor(place.Y / CellMetres) * 19_349_663)
        );
        return Mixed(unchecked((ulong)cell)) % MovingOneIn == 0
            ? WaveLevels * Math.Sin((2 * Math.PI * (place.X + place.Y + place.Z) / WaveMetres) + (WaveStep * tick))
            : 0;
    }

    /// <summary>A hash whose bits are independent of each other (the finaliser of SplitMix64).</summary>
    private static ulong Mixed(ulong value)
    {
        value = unchecked(value + 0x9E3779B97F4A7C15);
        value = unchecked((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9);
        value = unchecked((value ^ (value >> 27)) * 0x94D049BB133111EB);
        return value ^ (value >> 31);
    }
}
