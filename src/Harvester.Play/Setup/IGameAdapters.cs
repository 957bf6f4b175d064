using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Setup;

/// <summary>All that the features see of a game: one adapter for each of their ports.</summary>
public interface IGameAdapters
{
    /// <summary>Draws over the picture.</summary>
    IDisplay Display { get; }

    /// <summary>Switches radar and head-up display.</summary>
    IHudSwitch Hud { get; }

    /// <summary>The game's pause and its time.</summary>
    GameTime Time { get; }

    /// <summary>Casts rays.</summary>
    ISurfaceRays Rays { get; }

    /// <summary>Counts the calls to the game.</summary>
    ICallCounter Calls { get; }

    /// <summary>Records what could not be read of the game.</summary>
    ReadingRecord Reading { get; }

    /// <summary>The game's vehicles.</summary>
    IVehicles Vehicles { get; }

    /// <summary>The game's models.</summary>
    IModels Models { get; }

    /// <summary>The game's scripted cameras.</summary>
    ICameras Cameras { get; }

    /// <summary>Hides and shows entities.</summary>
    IShownEntities ShownEntities { get; }

    /// <summary>The controls of the player's vehicle, weather and time of day.</summary>
    ICarControls Controls { get; }

    /// <summary>The traffic lights.</summary>
    ITrafficLights TrafficLights { get; }

    /// <summary>The road nodes.</summary>
    IRoadSource Roads { get; }

    /// <summary>What trials of a plan need.</summary>
    ITrialGame Trials { get; }

    /// <summary>The entities and tasks of staged actors.</summary>
    IActorGame Actors { get; }

    /// <summary>Where models are put up to be measured.</summary>
    ISurveyStage Stage { get; }

    /// <summary>The player's position, metres, world.</summary>
    Vector3D PlayerPosition { get; }

    /// <summary>Makes the reader of the scene.</summary>
    /// <param name="mount">The camera and the vehicle that carries it.</param>
    /// <param name="faces">Returns the faces in use; no props of other models are read.</param>
    /// <param name="looksAround">Whether cameras look in other directions than the one read last.</param>
    GameScene SceneAround(CameraMount mount, Func<FaceTable> faces, Func<bool> looksAround);
}
