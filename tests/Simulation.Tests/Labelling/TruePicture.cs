using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>What a picture of the simulated game shows, by its renderer.</summary>
internal sealed class TruePicture
{
    private readonly Dictionary<int, List<int>> _pixels = [];
    private readonly int _width;

    public TruePicture(SceneSnapshot scene, RenderTarget picture)
    {
        Scene = scene;
        _width = picture.Width;
        for (int i = 0; i < picture.Handles.Length; i++)
        {
            if (picture.Handles[i] is var handle and not 0)
            {
                if (!_pixels.TryGetValue(handle, out List<int>? pixels))
                {
                    _pixels[handle] = pixels = [];
                }

                pixels.Add(i);
            }
        }
    }

    /// <summary>The true state of the moment that is shown, with all entities.</summary>
    public SceneSnapshot Scene { get; }

    /// <summary>The pixels at which an entity is seen, by their places in the image.</summary>
    public IReadOnlyList<int> PixelsOf(int handle) => _pixels.TryGetValue(handle, out List<int>? pixels) ? pixels : [];

    /// <summary>Which of an entity's pixels have their centres in a box.</summary>
    public int PixelsWithin(int handle, Box2D box) =>
        PixelsOf(handle)
            .Count(pixel =>
            {
                double x = (pixel % _width) + 0.5;
                double y = (pixel / _width) + 0.5;
                return x >= box.XMin && x <= box.XMax && y >= box.YMin && y <= box.YMax;
            });
}
