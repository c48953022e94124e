// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Handcraft runtime: loads a model file and predicts on the robot.
 *
 * C interface, C standard library types only. No function throws, prints or aborts. Memory is
 * allocated by hc_model_load_*, hc_workspace_create and nowhere else. A model is immutable: any
 * number of threads may use one, each with a workspace of its own. The same inputs give the same
 * bytes on every x86-64 processor with AVX2 and every arm64 one.
 *
 * The model file is specified in docs/model_format.md.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
/* NOLINTBEGIN(modernize-use-using): C has no using. */

#define HC_API __attribute__((visibility("default")))

/** What a call came to. Values are stable. */
typedef enum hc_status {
  HC_OK = 0,
  HC_ERROR_ARGUMENT = 1,   /**< A null pointer, wrong size or out-of-range number. */
  HC_ERROR_FILE = 2,       /**< The file cannot be opened or read. */
  HC_ERROR_MEMORY = 3,     /**< Out of memory while loading. */
  HC_ERROR_TRUNCATED = 4,  /**< The file ends too early, or is empty. */
  HC_ERROR_FORMAT = 5,     /**< Not a model file, or its header breaks the format. */
  HC_ERROR_CHECKSUM = 6,   /**< The CRC does not match: the file was damaged. */
  HC_ERROR_VERSION = 7,    /**< The format is newer (or too old) for this library. */
  HC_ERROR_KIND = 8,       /**< A valid model, of a kind this call cannot use. */
  HC_ERROR_CONTENT = 9,    /**< A tensor is missing, has another shape, or a bad value. */
  HC_ERROR_SELF_TEST = 10, /**< The stored self-test does not give the stored answer here. */
  HC_ERROR_IMAGE = 11,     /**< The image cannot be scored (needs colour, empty, too large). */
  HC_ERROR_CLOUD = 12,     /**< Fewer than three points of the object were measured, or (grasp
                              library) no plane fits them best or the mask has no halves. */
} hc_status;

/** Where and why loading failed; text is always terminated. */
typedef struct hc_error {
  hc_status status;
  uint64_t byte_offset; /**< Where in the file, or UINT64_MAX. */
  char message[240];    /**< One sentence: what was found, what was expected, what to do. */
} hc_error;

typedef struct hc_model hc_model;
typedef struct hc_workspace hc_workspace;

/** Loads and verifies a model: checksum, format, contents, self-test. error may be null. */
HC_API hc_status hc_model_load_file(const char* path, hc_model** model, hc_error* error);
/** As hc_model_load_file, from memory, which may be freed afterwards. */
HC_API hc_status hc_model_load_memory(const void* bytes,
                                      size_t size,
                                      hc_model** model,
                                      hc_error* error);
/** Frees a model; null is allowed. */
HC_API void hc_model_free(hc_model* model);

/** What a model is for. */
typedef enum hc_kind {
  HC_KIND_GRASP_POINT = 1,   /**< Pixel scores of an image: hc_score_image. */
  HC_KIND_LOGISTIC = 2,      /**< Probability of a row of numbers: hc_predict_row. */
  HC_KIND_SVM = 3,           /**< Class of a row of numbers: hc_classify_row. */
  HC_KIND_OBJECT_CLASS = 4,  /**< Class of an object's point cloud: hc_classify_cloud. */
  HC_KIND_GRASP_LIBRARY = 5, /**< How to hold an object: hc_find_grasp. */
} hc_kind;

/** What the model is for; 0 for null, as with the numbers below. */
HC_API hc_kind hc_model_kind(const hc_model* model);
/** Value of a metadata key ("hc.name", …) or null; lives as long as the model. */
HC_API const char* hc_model_metadata(const hc_model* model, const char* key);
/** Numbers in a feature vector (grasp point), in a row (logistic, svm) or of
    a cloud (object_class); 0 for a grasp library. */
HC_API size_t hc_model_num_features(const hc_model* model);
/** Whether a gray image is refused. */
HC_API int hc_model_needs_colour(const hc_model* model);

typedef enum hc_pixel_format { HC_GRAY8 = 0, HC_BGR8 = 1, HC_RGB8 = 2 } hc_pixel_format;

/** An 8-bit image in the caller's memory: row v starts at data + v * stride_bytes. */
typedef struct hc_image {
  const uint8_t* data;
  int32_t width;  /**< [px] */
  int32_t height; /**< [px] */
  int64_t stride_bytes;
  hc_pixel_format format;
} hc_image;

/** Scratch memory for images or clouds up to max_width x max_height [px] (grasp points, grasp
 * libraries). */
HC_API hc_status hc_workspace_create(const hc_model* model,
                                     int32_t max_width,
                                     int32_t max_height,
                                     hc_workspace** workspace);
HC_API void hc_workspace_free(hc_workspace* workspace);

/**
 * Probability that each pixel is a grasp point: row v at probabilities + v * stride (in floats).
 * Does not allocate. HC_ERROR_KIND, HC_ERROR_ARGUMENT, HC_ERROR_IMAGE.
 */
HC_API hc_status hc_score_image(const hc_model* model,
                                hc_workspace* workspace,
                                const hc_image* image,
                                float* probabilities,
                                int64_t stride);

/**
 * As hc_score_image for the pixels whose byte in `mask` is not 0 (row v at mask + v * mask_stride);
 * the others get 0. The numbers are those of hc_score_image, bit for bit. Picks what is sooner
 * done, scoring these pixels alone or all, by itself. Does not allocate. HC_ERROR_KIND,
 * HC_ERROR_ARGUMENT, HC_ERROR_IMAGE.
 */
HC_API hc_status hc_score_mask(const hc_model* model,
                               hc_workspace* workspace,
                               const hc_image* image,
                               const uint8_t* mask,
                               int64_t mask_stride,
                               float* probabilities,
                               int64_t stride);

typedef struct hc_pixel {
  int32_t u; /**< column [px] */
  int32_t v; /**< row [px] */
} hc_pixel;

/**
 * As hc_score_image for `count` pixels of the image: probabilities[i] is that of pixels[i]. Rows
 * must not descend (pixels[i].v <= pixels[i + 1].v); within a row any order, and repeats, will do.
 * Does not allocate. HC_ERROR_KIND, HC_ERROR_ARGUMENT, HC_ERROR_IMAGE.
 */
HC_API hc_status hc_score_pixels(const hc_model* model,
                                 hc_workspace* workspace,
                                 const hc_image* image,
                                 const hc_pixel* pixels,
                                 size_t count,
                                 float* probabilities);

typedef struct hc_point {
  int32_t u; /**< column [px] */
  int32_t v; /**< row [px] */
  float probability;
} hc_point;

/**
 * The best pixels of a probability map, best first (ties: smaller v, then smaller u): probability
 * > min_probability, and more than suppression_radius_px apart in the maximum norm (0: no
 * suppression). *count takes the capacity of points and returns the number found. Greedy; does not
 * allocate; O(width * height + k log k) without, O(width * height * k) at worst with suppression.
 */
HC_API hc_status hc_top_k(const float* probabilities,
                          int32_t width,
                          int32_t height,
                          int64_t stride,
                          float min_probability,
                          int32_t suppression_radius_px,
                          hc_point* points,
                          size_t* count);

/** Probability of label 1 for one row of hc_model_num_features numbers (logistic models). */
HC_API hc_status hc_predict_row(const hc_model* model,
                                const double* row,
                                size_t size,
                                double* probability);

/** Classes a model tells apart (svm, object_class) or knows (grasp library); 0 for other kinds. */
HC_API size_t hc_model_num_classes(const hc_model* model);
/** Name of a class, or null when there is none of this number; lives as long as the model. */
HC_API const char* hc_model_class_name(const hc_model* model, size_t number);

/**
 * Scratch memory for rows (svm models) or clouds of any size (object_class models). HC_ERROR_KIND,
 * HC_ERROR_ARGUMENT, HC_ERROR_MEMORY.
 */
HC_API hc_status hc_row_workspace_create(const hc_model* model, hc_workspace** workspace);

typedef struct hc_class_prediction {
  int32_t number;   /**< Of the class: hc_model_class_name; also when it is rejected. */
  int32_t rejected; /**< 1 when the margin is below the model's threshold: none of the classes. */
  double margin;    /**< The class's smallest decision value against another one. */
} hc_class_prediction;

/**
 * The class of one row of hc_model_num_features finite numbers. Does not allocate. HC_ERROR_KIND,
 * HC_ERROR_ARGUMENT (also for the workspace of another model).
 */
HC_API hc_status hc_classify_row(const hc_model* model,
                                 hc_workspace* workspace,
                                 const double* row,
                                 size_t size,
                                 hc_class_prediction* prediction);

/**
 * An organised point cloud in the caller's memory [m], in the frame of the model's metadata
 * (hc.frames): x, y, z of pixel (u, v) at points + v * row_stride + u * point_stride. A point with
 * a coordinate that is not finite, or beyond 1e6, was not measured.
 */
typedef struct hc_cloud {
  const float* points;
  int32_t width;        /**< [px] */
  int32_t height;       /**< [px] */
  int64_t row_stride;   /**< Floats from one row to the next. */
  int64_t point_stride; /**< Floats from one point to the next, at least 3. */
  const uint8_t* mask;  /**< Row v at mask + v * mask_stride; 0: not the object. Null: all is. */
  int64_t mask_stride;
} hc_cloud;

/** Decision values of one prediction (svm and object_class models); 0 for the other kinds. */
HC_API size_t hc_model_num_machines(const hc_model* model);

/**
 * The class of the object whose points are given (for a box of the picture let `points` and `mask`
 * begin at its first pixel). decision_values may be null; else it takes hc_model_num_machines
 * values. Does not allocate. HC_ERROR_KIND, HC_ERROR_ARGUMENT, HC_ERROR_CLOUD.
 */
HC_API hc_status hc_classify_cloud(const hc_model* model,
                                   hc_workspace* workspace,
                                   const hc_cloud* cloud,
                                   hc_class_prediction* prediction,
                                   double* decision_values);

typedef struct hc_grasp_request {
  int32_t class_number;   /**< as hc_model_class_name counts */
  int32_t num_neighbours; /**< demonstrations to average, 1 to 32; the dissertation's is 1 */
  double point_m[3];      /**< p_g: where to grasp, in the frame of the demonstrations */
} hc_grasp_request;

typedef struct hc_grasp {
  double position_m[3];      /**< of the hand when it was shown, brought to this object */
  double quaternion_xyzw[4]; /**< R_g: of the hand; real part last, not negative */
  double object_angle_rad;   /**< about z, as in the most similar view that is known */
  double turn_rad;           /**< from there to where grasps were shown, in [-pi, pi] */
  double distance_m;         /**< from the point to the nearest demonstration */
  int32_t view;              /**< which view of the class is the most similar one */
  int32_t demonstration;     /**< which demonstration is the nearest, as its file counts from 0 */
  int32_t rejected;          /**< 1: farther than the model allows; the pose means little */
} hc_grasp;

/**
 * How to hold an object of a known class at a point: its rotation about z by best-fit plane and
 * moments, then the nearest demonstrations (docs/methods/grasp_library.md). Does not allocate.
 * HC_ERROR_KIND, HC_ERROR_ARGUMENT (also for an unknown class, a point that is not finite and a
 * cloud larger than the workspace), HC_ERROR_CLOUD.
 */
HC_API hc_status hc_find_grasp(const hc_model* model,
                               hc_workspace* workspace,
                               const hc_cloud* cloud,
                               const hc_grasp_request* request,
                               hc_grasp* grasp);

/** One sentence for a status; never null. */
HC_API const char* hc_status_message(hc_status status);
/** "0.1.0" */
HC_API const char* hc_version(void);

/* NOLINTEND(modernize-use-using) */
#ifdef __cplusplus
} /* extern "C" */
#endif
