namespace Harvester.Sessions.Scenes;

/// <summary>What kind of thing an object of a scene is. In files its name begins with a small letter.</summary>
public enum ObjectClass
{
    /// <summary>A passenger car, pick-up or van.</summary>
    Car,

    /// <summary>A lorry, fire engine or other heavy goods vehicle.</summary>
    Truck,

    /// <summary>A bus.</summary>
    Bus,

    /// <summary>A motorcycle.</summary>
    Motorcycle,

    /// <summary>A bicycle.</summary>
    Bicycle,

    /// <summary>A trailer.</summary>
    Trailer,

    /// <summary>A person on foot.</summary>
    Pedestrian,

    /// <summary>A traffic sign.</summary>
    Sign,

    /// <summary>A traffic light.</summary>
    TrafficLight,

    /// <summary>Whatever else is labelled.</summary>
    Other,
}
