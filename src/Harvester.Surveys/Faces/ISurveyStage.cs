using Harvester.Geometry.Visibility;

namespace Harvester.Surveys.Faces;

/// <summary>
/// A quiet place of a game where models are placed one at a time and measured. All calls come from the game's own thread; exceptions
/// of the game are passed on.
/// </summary>
public interface ISurveyStage
{
    /// <summary>Casts rays at the placed model.</summary>
    IRayCaster Rays { get; }

    /// <summary>Asks the game to load a model, and says how far it is; called every tick until it is loaded or not to be had.</summary>
    /// <param name="model">The name of the model in the game.</param>
    ModelLoading Load(string model);

    /// <summary>Lets the game unload a model that was requested. Further calls do nothing.</summary>
    /// <param name="model">The name of the model in the game.</param>
    void Forget(string model);

    /// <summary>Puts a loaded model up where nothing else is.</summary>
    /// <param name="model">The name of the model in the game.</param>
    /// <returns>The entity's handle; 0 when the game refuses.</returns>
    int PutUp(string model);

    /// <summary>Keeps what was put up where it is.</summary>
    /// <param name="entity">Handle of the placed entity.</param>
    void Hold(int entity);

    /// <summary>Reads a model that was put up.</summary>
    /// <param name="entity">Handle of the placed entity.</param>
    /// <param name="model">The name of the model in the game.</param>
    StagedModel Read(int entity, string model);

    /// <summary>Whether what was put up is still there; a saved game that is loaded sweeps it away.</summary>
    /// <param name="entity">Handle of the placed entity.</param>
    bool IsStanding(int entity);

    /// <summary>Takes an entity away that was put up. One that is gone is no harm.</summary>
    void TakeAway(int entity);
}
