using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Maps of the normals of surfaces: as drawn, where the game knows what its picture shows, else from rays. docs/normals.md describes them.
/// </summary>
internal sealed class NormalsCapture() : CaptureChannel(FrameChannels.Normals)
{
    /// <inheritdoc />
    public override bool NeedsNormals(GamePorts game) => game.Surfaces is null;

    /// <inheritdoc />
    public override string? ProblemFor(HarvestOptions options, GamePorts game) =>
        options.Freeze && (game.Surfaces is not null || game.SurfaceRays is not null)
            ? null
            : "Normals need a game that is frozen for each frame and reports normals.";

    /// <inheritdoc />
    public override IChannelLabeller LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) =>
        new Labeller(rays, game.Surfaces);

    private sealed class Labeller(FrameRays rays, ISurfaceTruth? truth) : IChannelLabeller
    {
        public ChannelTurn Turn => ChannelTurn.Last;

        public string RaysKey => FrameChannels.Normals.RaysKey;

        public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
        {
            var map = new PixelBuffer(draft.Camera.Image);
            if (truth is not null)
            {
                IReadOnlyList<Vector3D> drawn = truth.Normals(draft.Camera.Image);
                for (int pixel = 0; pixel < drawn.Count; pixel++)
                {
                    Write(map, pixel, draft.Camera.Pose.Axes.ToLocal(drawn[pixel]));
                }

                draft.Add(new MapPart(FrameChannels.Normals, map, SemanticsMethod.Exact, 0));
                yield break;
            }

            var surfaces = new FrameSurfaces(rays, draft);
            yield return WorkStep.Do(surfaces.Sample(mayCastRays));

            // Each pixel has the normal of the surface that its depth would be taken from: that of the nearest sample on the same object.
            int[] sources = surfaces.Complete().Sources;
            for (int pixel = 0; pixel < sources.Length; pixel++)
            {
                if (sources[pixel] >= 0 && surfaces.Samples[sources[pixel]] is { IsHit: true } sample)
                {
                    // The normal n of a plane n · p = 1 points away from the eye, where p is seen.
                    Write(map, pixel, -sample.Surface.Normal);
                }
            }

            draft.Add(new MapPart(FrameChannels.Normals, map, SemanticsMethod.Rays, surfaces.RaysCast));
        }

        /// <summary>
        /// Writes a normal of the camera's axes right, forward and up: 128 + 127 c for each component c of the unit vector along right,
        /// down and forward; 0, 0, 0 for none.
        /// </summary>
        private static void Write(PixelBuffer map, int pixel, Vector3D normal)
        {
            double length = normal.Length;
            if (length > 0)
            {
                int at = pixel * PixelBuffer.BytesPerPixel;
                map.Bytes[at] = Coded(normal.X / length);
                map.Bytes[at + 1] = Coded(-normal.Z / length);
                map.Bytes[at + 2] = Coded(normal.Y / length);
            }
        }

        private static byte Coded(double component) => (byte)Math.Round(128 + (127 * component));
    }
}
