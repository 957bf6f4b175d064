using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Spaces.Survey;

/// <summary>A quiet place of a game where models are put up one at a time and measured. All calls come from the game's own thread; a failure is thrown as it is.</summary>
public interface ISurveyStage
{
    /// <summary>What rays meet.</summary>
    IRayCaster Rays { get; }

    /// <summary>Asks the game to load a model, and says how far it is; called every tick until it is loaded or not to be had.</summary>
    /// <param name="model">The model's name.</param>
    ModelLoading Load(string model);

    /// <summary>Puts a loaded model up.</summary>
    /// <param name="model">The model's name.</param>
    /// <returns>Null when the game refuses.</returns>
    StagedModel? PutUp(string model);

    /// <summary>Takes an entity away that was put up. One that is gone is no harm.</summary>
    void TakeAway(int entity);
}
