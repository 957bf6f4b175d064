namespace Harvester.Sessions.Scenes;

/// <summary>The class of an object. In files its name begins with a lower-case letter.</summary>
public enum ObjectClass
{
    /// <summary>A passenger car, pick-up or van.</summary>
    Car,

    /// <summary>A truck, fire engine or other heavy goods vehicle.</summary>
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

    /// <summary>Any other labelled object.</summary>
    Other,

    /// <summary>A person on a motorcycle or bicycle.</summary>
    Rider,
}
