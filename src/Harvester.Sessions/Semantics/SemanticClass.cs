namespace Harvester.Sessions.Semantics;

/// <summary>What a pixel shows; the numbers are values in class maps. From <see cref="Car"/> on they are classes of objects.</summary>
public enum SemanticClass : byte
{
    /// <summary>Unknown.</summary>
    None = 0,

    /// <summary>The surface that vehicles drive on, including what is packed earth on unpaved roads.</summary>
    Road = 1,

    /// <summary>Pavement, kerbs, and other paved ground beside roads.</summary>
    Pavement = 2,

    /// <summary>Paint on a road.</summary>
    LaneMarking = 3,

    /// <summary>Buildings, bridges, walls.</summary>
    Building = 4,

    /// <summary>Trees, bushes, hedges.</summary>
    Vegetation = 5,

    /// <summary>Grass, soil, sand, rock.</summary>
    Terrain = 6,

    /// <summary>The sky.</summary>
    Sky = 7,

    /// <summary>Water.</summary>
    Water = 8,

    /// <summary>Lamp posts and other poles that are no objects.</summary>
    Pole = 9,

    /// <summary>Fences, railings, parapets.</summary>
    Fence = 10,

    /// <summary>A car.</summary>
    Car = 11,

    /// <summary>A truck.</summary>
    Truck = 12,

    /// <summary>A bus.</summary>
    Bus = 13,

    /// <summary>A motorcycle.</summary>
    Motorcycle = 14,

    /// <summary>A bicycle.</summary>
    Bicycle = 15,

    /// <summary>A trailer.</summary>
    Trailer = 16,

    /// <summary>A person on foot. Class maps without <see cref="Rider"/> also have riders so.</summary>
    Pedestrian = 17,

    /// <summary>A traffic sign with its post.</summary>
    Sign = 18,

    /// <summary>A traffic light with its post.</summary>
    TrafficLight = 19,

    /// <summary>Anything else.</summary>
    Other = 20,

    /// <summary>A person on a motorcycle or bicycle.</summary>
    Rider = 21,
}
